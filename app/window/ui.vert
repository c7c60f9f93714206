#version 450
// ImGui's triangles, pulled from storage buffers: one index for each vertex.
struct Vertex {
  float x, y, u, v;
  uint colour;  // 0xAABBGGRR
};
layout(set = 0, binding = 0, std430) readonly buffer Vertices { Vertex vertices[]; };
layout(set = 0, binding = 1, std430) readonly buffer Indices { uint indices[]; };
layout(push_constant) uniform Push { vec2 to_clip; } push;
layout(location = 0) out vec2 uv;
layout(location = 1) out vec4 colour;

void main() {
  const Vertex vertex = vertices[indices[gl_VertexIndex]];
  uv = vec2(vertex.u, vertex.v);
  colour = unpackUnorm4x8(vertex.colour);
  gl_Position = vec4(vec2(vertex.x, vertex.y) * push.to_clip - 1.0, 0.0, 1.0);
}
