// A lost context: the renderer makes a new one and the picture is as it was.
#include <epoxy/egl.h>
// epoxy's EGL must come before its GL.
#include <epoxy/gl.h>

#include <cstring>
#include <optional>

#include "tests/viewport/scenes.h"
#include "viewport/gl/egl_context.h"
#include "viewport/gl_renderer.h"

namespace plinian::test {
namespace {

// What the driver says of resets is made up here, through the pointer that the loader calls it by.
int resets_to_come = 0, answers_before = 0;
GLenum made_up_reset_status() {
  if (answers_before-- > 0 || resets_to_come <= 0) return GL_NO_ERROR;
  --resets_to_come;
  return GL_INNOCENT_CONTEXT_RESET;
}

class LostContext : public testing::Test {
 protected:
  // Each loss is told once, as a driver tells it, after so many answers that nothing is wrong.
  void lose(int times, int after = 0) {
    epoxy_glGetGraphicsResetStatus = made_up_reset_status;
    resets_to_come = times;
    answers_before = after;
  }
  void TearDown() override {
    epoxy_glGetGraphicsResetStatus = real_;
    resets_to_come = 0;
  }
  PFNGLGETGRAPHICSRESETSTATUSPROC real_ = epoxy_glGetGraphicsResetStatus;
  SceneSnapshot scene = ash_scene(32, 48);
};

TEST_F(LostContext, IsToldOfWhereTheDriverCan) {
  gl::EglContext context;
  const char* extensions = eglQueryString(eglGetCurrentDisplay(), EGL_EXTENSIONS);
  if (!std::strstr(extensions, "EGL_EXT_create_context_robustness"))
    GTEST_SKIP() << "this driver does not tell of resets";
  GLint strategy = 0;
  glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
  EXPECT_EQ(strategy, GL_LOSE_CONTEXT_ON_RESET);
}

TEST_F(LostContext, DestroyedBetweenTwoPicturesIsMadeAnew) {
  const auto renderer = make_gl_renderer();
  const Frame before = renderer->render(scene, 2);
  const auto builds = renderer->stats().map_builds, uploads = renderer->stats().volume_uploads;
  const EGLDisplay display = eglGetCurrentDisplay();
  const EGLContext context = eglGetCurrentContext();
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
  ASSERT_TRUE(eglDestroyContext(display, context));
  const Frame after = renderer->render(scene, 2);
  EXPECT_EQ(largest_difference(before, after), 0.0);
  EXPECT_EQ(renderer->stats().map_builds, 2 * builds) << "everything on the GPU was lost";
  EXPECT_EQ(renderer->stats().volume_uploads, 2 * uploads);
  EXPECT_EQ(largest_difference(before, renderer->render(scene, 2)), 0.0);
  EXPECT_EQ(renderer->stats().map_builds, 2 * builds) << "what is there again is kept again";
}

TEST_F(LostContext, ResetInTheMiddleOfAPictureGivesThatPictureAllTheSame) {
  const auto renderer = make_gl_renderer();
  const Frame before = renderer->render(scene, 2);
  const auto builds = renderer->stats().map_builds;
  // The first answer is asked for before the picture, the second after its passes.
  lose(1, 1);
  scene.camera.focal_length *= 1.2f;
  const Frame turned = renderer->render(scene, 2);
  EXPECT_EQ(resets_to_come, 0);
  EXPECT_EQ(renderer->stats().map_builds, 2 * builds);
  EXPECT_EQ(largest_difference(turned, make_gl_renderer()->render(scene, 2)), 0.0);
  EXPECT_GT(largest_difference(before, turned), 0.05);
}

TEST_F(LostContext, ThatIsLostAgainAndAgainIsAnErrorAndTheNextPictureIsRight) {
  const auto renderer = make_gl_renderer();
  const Frame before = renderer->render(scene, 1);
  lose(2);
  try {
    renderer->render(scene, 1);
    FAIL() << "rendered on a lost context";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("lost again"), std::string::npos) << error.what();
  }
  EXPECT_EQ(largest_difference(before, renderer->render(scene, 1)), 0.0);
}

TEST_F(LostContext, OfAWindowIsLeftToTheWindow) {
  std::optional<gl::EglContext> window(std::in_place);
  const auto renderer = make_gl_renderer_on_current_context();
  const Frame before = renderer->render(scene, 1);
  lose(1);
  EXPECT_THROW(renderer->render(scene, 1), std::runtime_error);
  // A new context in its place.
  window.reset();
  window.emplace();
  EXPECT_EQ(largest_difference(before, renderer->render(scene, 1)), 0.0);
}

}  // namespace
}  // namespace plinian::test
