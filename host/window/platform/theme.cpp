// Colours, distances, fonts.
#include "host/window/platform/theme.h"

#include <imgui.h>

#include <cmath>
#include <filesystem>

namespace plinian::window {

namespace {

Fonts loaded;
float interface_scale = 1.0f;

// The first of these that is installed.
ImFont* load_font(std::initializer_list<const char*> paths, float size) {
  static const ImWchar ranges[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x2010, 0x2044, 0x2070,
                                   0x209F, 0x2190, 0x2193, 0x2200, 0x22FF, 0};
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  for (const char* path : paths)
    if (std::filesystem::exists(path))
      if (ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(path, size, &config, ranges)) return font;
  config.SizePixels = size;
  return ImGui::GetIO().Fonts->AddFontDefault(&config);
}

ImVec4 grey(float value, float alpha = 1.0f) {
  return {value, value * 1.005f, value * 1.02f, alpha};
}

}  // namespace

const Fonts& fonts() {
  return loaded;
}

float scaled(float points) {
  return std::round(points * interface_scale);
}

void set_theme(double scale) {
  interface_scale = float(scale);
  const auto size = [&](double points) { return float(std::round(points * scale)); };
  loaded.text = load_font({"/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
                           "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                           "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"},
                          size(15));
  loaded.bold = load_font({"/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
                           "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf",
                           "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
                          size(15));
  loaded.fixed = load_font({"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf"},
                           size(13));

  ImGuiStyle style;
  style.WindowPadding = {8, 8};
  style.WindowMinSize = {1, 1};
  style.FramePadding = {7, 3};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 2};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 8;
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.FrameRounding = 3;
  style.PopupRounding = 4;
  style.GrabRounding = 3;
  style.TabRounding = 3;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.SelectableTextAlign = {0.0f, 0.5f};
  style.DisabledAlpha = 0.45f;
  ImGui::StyleColorsDark(&style);
  const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(colour::accent);
  const auto tint = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(colour::text);
  c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(colour::faint_text);
  c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = grey(colour::pane);
  c[ImGuiCol_MenuBarBg] = grey(0.115f);
  c[ImGuiCol_PopupBg] = grey(0.125f, 0.985f);
  c[ImGuiCol_Border] = grey(0.25f);
  c[ImGuiCol_FrameBg] = grey(0.205f);
  c[ImGuiCol_FrameBgHovered] = grey(0.25f);
  c[ImGuiCol_FrameBgActive] = grey(0.29f);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = grey(0.115f);
  c[ImGuiCol_ScrollbarBg] = grey(0.145f, 0.0f);
  c[ImGuiCol_ScrollbarGrab] = grey(0.27f);
  c[ImGuiCol_ScrollbarGrabHovered] = grey(0.33f);
  c[ImGuiCol_ScrollbarGrabActive] = grey(0.4f);
  c[ImGuiCol_CheckMark] = accent;
  c[ImGuiCol_SliderGrab] = tint(0.8f);
  c[ImGuiCol_SliderGrabActive] = accent;
  c[ImGuiCol_Button] = grey(0.215f);
  c[ImGuiCol_ButtonHovered] = grey(0.27f);
  c[ImGuiCol_ButtonActive] = grey(0.32f);
  c[ImGuiCol_Header] = tint(0.22f);
  c[ImGuiCol_HeaderHovered] = grey(0.24f);
  c[ImGuiCol_HeaderActive] = tint(0.32f);
  c[ImGuiCol_Separator] = grey(0.09f);
  c[ImGuiCol_SeparatorHovered] = tint(0.5f);
  c[ImGuiCol_SeparatorActive] = accent;
  c[ImGuiCol_ResizeGrip] = grey(0.25f, 0.0f);
  c[ImGuiCol_Tab] = grey(0.165f);
  c[ImGuiCol_TabHovered] = grey(0.26f);
  c[ImGuiCol_TabActive] = grey(0.215f);
  c[ImGuiCol_TextSelectedBg] = tint(0.35f);
  c[ImGuiCol_NavHighlight] = tint(0.6f);
  c[ImGuiCol_DragDropTarget] = accent;
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.45f);
  style.ScaleAllSizes(float(scale));
  ImGui::GetStyle() = style;
}

}  // namespace plinian::window
