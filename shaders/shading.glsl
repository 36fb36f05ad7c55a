// The shading models, and the code that they share.

//// shading.glsl
// Input and output of every shading model. A model is one file shading_<name>.glsl with two functions:
//
//   void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color)
//       Adds the light of one source. `towards`: unit, to the light. `color`: linear, the radiance of a white matte
//       surface that faces the light; for a distant light, its irradiance over pi.
//   vec3 tint(Strand strand)
//       The factor of the finished sums.
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

// Sums of the parts that a picture may show separately (Component in coif/renderer.h).
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

//// shading_thesis.glsl
// Algorithm 3 of the thesis (5.3.2), the model of Scheuermann 2004 with small changes.
//
//   diffuse    saturate(mix(0.5, 1, N.L))
//   highlight  smoothstep(-1, 0, T.H) (1 - (T.H)^2)^(exponent / 2) color, H = normalize(V + L), T the tangent moved
//              along the normal by the material's shift and the texture's; the texture masks the secondary one
//
// Reads primary and secondary (rgb, exponent) and shift.xy of the block. Sums are multiplied with the strand's colour.

vec3 tint(Strand strand) { return strand.color; }

float strand_specular(vec3 t, vec3 view, vec3 towards, float exponent) {
  vec3 sum = view + towards;
  // A light straight behind the hair has no half vector; any finite one will do.
  vec3 half_vector = sum / max(length(sum), 1e-6);
  float t_dot_h = dot(t, half_vector);
  float sin_th = sqrt(max(1.0 - t_dot_h * t_dot_h, 0.0));
  return smoothstep(-1.0, 0.0, t_dot_h) * pow(sin_th, exponent);
}

// A highlight without colour is left out.
void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color) {
  sum.diffuse += clamp(mix(0.5, 1.0, dot(strand.normal, towards)), 0.0, 1.0) * color;
#ifdef COIF_PRIMARY
  vec3 t1 = shift_tangent(strand.tangent, strand.normal, shift.x + strand.shift);
  sum.primary += strand_specular(t1, strand.view, towards, primary.w) * primary.rgb * color;
#endif
#ifdef COIF_SECONDARY
  vec3 t2 = shift_tangent(strand.tangent, strand.normal, shift.y + strand.shift);
  sum.secondary += strand_specular(t2, strand.view, towards, secondary.w) * secondary.rgb * strand.mask * color;
#endif
}

//// shading_kajiya_kay.glsl
// Kajiya and Kay 1989, "Rendering fur with three dimensional textures", section 3.2.
//
//   diffuse    sin(T, L): a matte cylinder too thin to see, whose lit half is seen as a whole
//   highlight  max(sin(T, L) sin(T, V) - cos(T, L) cos(T, V), 0)^exponent color: the cosine of the angle between V and
//              the cone of mirrored light, whose axis is the strand
//
// Reads primary (rgb, exponent) of the block. As published there is one highlight, and every strand of a sheet has it
// at the same place; here the texture's shift moves it, or cards would shine like foil. Sums are multiplied with the
// strand's colour.

vec3 tint(Strand strand) { return strand.color; }

float sine_to(float cosine) { return sqrt(max(1.0 - cosine * cosine, 0.0)); }

void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color) {
  sum.diffuse += sine_to(dot(strand.tangent, towards)) * color;
#ifdef COIF_PRIMARY
  vec3 t = shift_tangent(strand.tangent, strand.normal, strand.shift);
  float cos_l = dot(t, towards), cos_v = dot(t, strand.view);
  float to_cone = sine_to(cos_l) * sine_to(cos_v) - cos_l * cos_v;
  sum.primary += pow(max(to_cone, 0.0), primary.w) * primary.rgb * color;
#endif
}

//// shading_marschner.glsl
// Light through a fibre: Marschner et al. 2003, "Light scattering from human hair fibers", with the curves that Karis
// fitted to it ("Physically based hair shading in Unreal", SIGGRAPH 2016 course), and a share that many strands
// scatter.
//
// Three ways through the fibre, each M(along the strand) N(around it):
//   R    reflected by the surface
//   TT   through the fibre; strong against the light
//   TRT  reflected by the far side; coloured, the second highlight
// M is a Gaussian of sin(theta_l) + sin(theta_v) around -2 tilt, tilt, 4 tilt with the widths w, w / 2, 2 w. N are
//   R    1/4 cos(phi / 2) F                              F at the half angle
//   TT   exp(-3.65 cos(phi) - 3.98) (1 - F)^2 A          F at h, A = color^(sqrt(1 - (h / n')^2) / (2 cos(theta_d)))
//   TRT  exp(17 cos(phi) - 16.78) (1 - F)^2 F A          F at h = sqrt(3) / 2, A = color^(0.8 / cos(theta_d))
// with Schlick's F for n = 1.55, n' = sqrt(n^2 - sin^2(theta_d)) / cos(theta_d), and h = cos(phi / 2) (1 + (0.6 - 0.8
// cos(phi)) / n'). dot(L, T) = sin(theta_l) makes each M integrate to 1 over d sin(theta_l), and M N over directions to
// what N lets through, so that a fibre never sends out more than it gets. With `scatter` s, TT keeps 1 - s of its
// light; what others would pass on is
//   s (1 - F)^2 color saturate((N.L + 0.5) / 2.25), which is color at most where light comes from everywhere.
// Strands lie on a head: all of it fades as the light goes behind the surface, saturate(1 + 2 N.L).
//
// Reads fiber (x: tilt, y: width w, z: scatter) of the block. Colours are in the sums already.

const float kPi = 3.14159265;
const float kIndexSquare = 2.4025;     // n = 1.55
const float kReflectance = 0.0465;     // ((n - 1) / (n + 1))^2
const float kWrap = 0.5;               // how far around strands scatter light

vec3 tint(Strand strand) { return vec3(1.0); }

float fresnel(float cosine) {
  float away = 1.0 - clamp(cosine, 0.0, 1.0);
  return kReflectance + (1.0 - kReflectance) * away * pow2(pow2(away));
}

float gaussian(float x, float width) {
  return exp(-0.5 * pow2(x / width)) * inversesqrt(2.0 * kPi) / width;
}

// Angles of light and eye at the fibre.
struct Angles {
  float sine_sum;      // sin(theta_l) + sin(theta_v)
  float cos_d;         // of half the difference of both thetas
  float cos_phi;       // of the angle around the fibre between them
  float cos_half_phi;
  float cos_half;      // of half the angle between them
};

Angles angles_between(vec3 t, vec3 view, vec3 towards) {
  float sin_l = clamp(dot(t, towards), -1.0, 1.0), sin_v = clamp(dot(t, view), -1.0, 1.0);
  vec3 around_l = towards - sin_l * t, around_v = view - sin_v * t;
  // Along the fibre there is no angle around it; any finite one will do.
  float cos_phi = dot(around_l, around_v) * inversesqrt(max(dot(around_l, around_l) * dot(around_v, around_v), 1e-8));
  cos_phi = clamp(cos_phi, -1.0, 1.0);
  // cos((a - b) / 2)^2 = (1 + cos(a) cos(b) + sin(a) sin(b)) / 2
  float cosines = sqrt((1.0 - sin_l * sin_l) * (1.0 - sin_v * sin_v));
  return Angles(sin_l + sin_v, sqrt(clamp(0.5 + 0.5 * (cosines + sin_l * sin_v), 0.01, 1.0)), cos_phi,
                sqrt(0.5 + 0.5 * cos_phi), sqrt(clamp(0.5 + 0.5 * dot(view, towards), 0.0, 1.0)));
}

vec3 transmitted(Angles angles, vec3 color) {
  float bent = sqrt(kIndexSquare - 1.0 + pow2(angles.cos_d)) / angles.cos_d;  // n'
  float h = min(angles.cos_half_phi * (1.0 + (0.6 - 0.8 * angles.cos_phi) / bent), 1.0);
  float f = fresnel(angles.cos_d * sqrt(1.0 - h * h));
  vec3 absorbed = pow(color, vec3(0.5 * sqrt(1.0 - pow2(h / bent)) / angles.cos_d));
  return exp(-3.65 * angles.cos_phi - 3.98) * pow2(1.0 - f) * absorbed;
}

void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color) {
  float n_dot_l = dot(strand.normal, towards);
  vec3 light = color * clamp(1.0 + 2.0 * n_dot_l, 0.0, 1.0);
  vec3 base = clamp(strand.color, 0.0, 1.0);
  vec3 t = shift_tangent(strand.tangent, strand.normal, strand.shift);
  Angles angles = angles_between(t, strand.view, towards);
  float tilt = fiber.x, width = fiber.y, scatter = fiber.z;

  float r = gaussian(angles.sine_sum + 2.0 * tilt, width) * 0.25 * angles.cos_half_phi * fresnel(angles.cos_half);
  sum.primary += kPi * r * light;

  vec3 tt = gaussian(angles.sine_sum - tilt, 0.5 * width) * transmitted(angles, base);
  float f = fresnel(0.5 * angles.cos_d);
  vec3 scattered = pow2(1.0 - f) * clamp((n_dot_l + kWrap) / pow2(1.0 + kWrap), 0.0, 1.0) * base;
  sum.diffuse += mix(kPi * tt, scattered, scatter) * light;

  vec3 absorbed = pow(base, vec3(0.8 / angles.cos_d));
  vec3 trt = gaussian(angles.sine_sum - 4.0 * tilt, 2.0 * width) * exp(17.0 * angles.cos_phi - 16.78) *
             pow2(1.0 - f) * f * absorbed;
  sum.secondary += kPi * strand.mask * trt * light;
}
