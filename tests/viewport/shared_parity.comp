// Evaluates the shared maths on the GPU; shared_parity_test.cpp puts shared_parity.h in the place of PARITY_VALUES.

layout(local_size_x = 16) in;
layout(std430, binding = 0) writeonly buffer Results { float u_results[]; };

PARITY_VALUES

void main() {
  int i = int(gl_GlobalInvocationID.x);
  for (int k = 0; k < parity_functions; ++k) u_results[i * parity_functions + k] = parity_value(k, float(i) / 255.0f);
}
