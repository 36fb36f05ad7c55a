// What every shading model is given and gives back. A model is one file shading_<name>.glsl with two functions:
//
//   void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color)
//       Adds what one light gives. `towards`: unit, to the light. `color`: linear, as much as a white matte surface that
//       faces the light sends out; of a distant light that is its irradiance over pi.
//   vec3 tint(Strand strand)
//       What the finished sums are multiplied with.
//
// All vectors are in view space. shaders/SHADING.md has all models side by side.

struct Strand {
  vec3 tangent;  // unit, root to tip
  vec3 normal;   // unit, of the side that is seen
  vec3 view;     // unit, towards the eye
  vec3 color;    // linear: base texture times base colour
  float shift;   // of the highlights along the strand, -0.5..0.5, from the texture
  float mask;    // of the secondary highlight, 0..1, from the texture
};

// In the parts that a picture may show apart (Component in coif/renderer.h).
struct Reflected {
  vec3 diffuse;
  vec3 primary;
  vec3 secondary;
};

// ShiftTangent() of the thesis: a strand that leans towards the normal has its highlight further along itself.
vec3 shift_tangent(vec3 t, vec3 n, float amount) {
  return normalize(t + amount * n);
}

float pow2(float x) { return x * x; }
