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
// A model that defines COIF_MANY_FIBERS has four more, for which hair.frag has simple forms else:
//
//   vec3 sky_reflected(Strand strand, float openness)
//       The share of light from everywhere alike that is seen. `openness`: of the directions, those that nothing hides.
//   vec3 shaded_place(Strand strand)
//       Where shadows are looked up for the point `position`.
//   vec3 passing(Strand strand, float share)
//       What arrives of light of which hair on its way leaves that share.
//   vec3 reach_without_map(Strand strand, float openness)
//       What arrives of a light that no shadow map says.
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

// The place that lies so far outside of the hair, in metres of a head at scale 1.
vec3 outside(float metres, Strand strand) { return position + metres * head_scale() * strand.normal; }

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

//// shading_volume.glsl
// Hair as a volume of fibres along T, endless below a surface with the normal N: what is seen of it from outside, in
// closed form. Single scattering is exact but for its lobes; light that fibres hand on was computed by following it at
// random (kVolume in shaders/SHADING.md) and is fit here. theta and phi are the angles out of the plane across T and
// around T; n = N.L / cos(theta) is how steeply a direction leaves the volume as seen along T.
//
//   once     P(L, V) / (cos(theta_v) + cos(theta_l) (N.V) / (N.L)), P = sum over R, TT, TRT of A M N: the share of what
//            a fibre meets that it sends out, per solid angle (Lommel and Seeliger's law, with fibres that hide less
//            the more they are seen along themselves)
//   more     3.6 color (1 + h n_l) (1 + h n_v) / (1 + h)^2 cone(s + e) over the same denominator
//
// with s = sin(theta_l) + sin(theta_v), and cone, h, e that grow with the colour, since light that loses less wanders
// farther. Fibres are those of Chiang et al. 2016, "A practical and controllable hair and fur model for production path
// tracing", averaged over the fibre's width: radial roughness 0.5, and a longitudinal variance that is the square of
// the material's roughness. The base colour is theirs, too: that of the hair as a whole in white light.
//
// Reads fiber (x: tilt, y: width w) of the block. Colours are in the sums already.

#define COIF_MANY_FIBERS

const float kPi = 3.14159265;
const float kFiberIndex = 1.55;
const float kColorScale = 5.509;  // Chiang et al.'s, for radial roughness 0.5: absorption = (log(color) / it)^2
const float kShiftShare = 0.2;  // of the texture's shift: how much fibres lean apart within a lock
const float kOwnDepth = 0.006;  // metres of a head at scale 1: some three times as far as light gets into hair unhindered
const float kApart = 0.45;  // radians: how far the fibres that hand light on run apart
const float kLeastOnce = 0.25, kLeastOften = 0.7;  // fibres that are seen along themselves hide each other all the same
const float kMostShift = 0.36;  // of the cook's textures, in which all numbers up to this are equally frequent
// Such numbers' deviation is 1 / sqrt(3), so that 1.73 is all; and less of the ratio where light comes from all around.
const float kDepthsApart = 1.4, kOftenApart = 0.55, kSkyApart = 0.6;
const float kRound = 0.06;        // a light behind the surface still reaches the round outline of locks

vec3 tint(Strand strand) { return vec3(1.0); }

float gaussian(float x, float width) {
  return exp(-0.5 * pow2(x / width)) * inversesqrt(2.0 * kPi) / width;
}

// A cosine that fades out below 0 rather than ending there.
float rounded(float cosine) { return 0.5 * (cosine + sqrt(cosine * cosine + kRound * kRound)); }

// The inside of a lock, seen through a gap, is as steep to the eye as its outside.
float facing(float cosine) { return sqrt(cosine * cosine + 0.25 * kRound * kRound); }

vec3 volume_color(Strand strand) { return clamp(strand.color, 0.002, 0.95); }

// What lies just outside of a fibre shades it as the closed form says; a shadow is of what is farther away.
vec3 shaded_place(Strand strand) { return outside(kOwnDepth, strand); }

// Some half of the directions lie behind the surface.
float volume_openness(float openness) { return min(1.75 * openness, 1.0); }

// Light that hair has passed goes on forwards, the more of it the lighter the hair is.
vec3 passing(Strand strand, float share) {
  return pow(vec3(max(share, 1e-4)), 1.0 - sqrt(volume_color(strand)));
}

vec3 reach_without_map(Strand strand, float openness) { return passing(strand, volume_openness(openness)); }

float mean_of(vec3 color) { return dot(color, vec3(1.0 / 3.0)); }

// Light that hair has handed on comes from all around, the more of it the lighter the hair is, and levels fibres out.
float uneven(vec3 base) { return 1.0 - sqrt(mean_of(base)); }

// A fibre's own share of the mean light of its place. Some of the fibres that are seen lie deeper than others: where
// light falls off `ratio` times as fast as sight, they differ by ratio / sqrt(1 + 2 ratio) of the mean (deviation). The
// texture's shift tells them apart: linearly, so that its averages keep the mean.
float own_share(Strand strand, float ratio) {
  float apart = min(kDepthsApart * ratio * inversesqrt(1.0 + 2.0 * ratio), 1.0);
  return 1.0 + apart * clamp(strand.shift / kMostShift, -1.0, 1.0);
}

vec3 sky_reflected(Strand strand, float openness) {
  vec3 color = volume_color(strand);
  float along = dot(strand.tangent, strand.view);
  float leaving = facing(dot(strand.normal, strand.view)) * inversesqrt(max(1.0 - along * along, 0.04));
  float grazing = pow(max(1.0 - leaving, 0.0), 1.5);
  vec3 dark = vec3(1.0) - color, root = sqrt(color);
  vec3 open = pow(vec3(max(volume_openness(openness), 1e-4)), 1.4 - 1.1 * root);
  return own_share(strand, kSkyApart * uneven(color)) * open *
         (color + dark * (0.013 * dark + (0.11 + 0.7 * grazing) * root));
}

void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color) {
  vec3 base = volume_color(strand);
  float tilt = fiber.x, width = fiber.y;
  vec3 t = shift_tangent(strand.tangent, strand.normal, kShiftShare * strand.shift);
  float sin_l = clamp(dot(t, towards), -0.999, 0.999), sin_v = clamp(dot(t, strand.view), -0.999, 0.999);
  float cos_l = sqrt(1.0 - sin_l * sin_l), cos_v = sqrt(1.0 - sin_v * sin_v);
  float cos_phi = clamp((dot(towards, strand.view) - sin_l * sin_v) / (cos_l * cos_v), -1.0, 1.0);
  float phi = acos(cos_phi);
  float in_l = rounded(dot(strand.normal, towards)), in_v = facing(dot(strand.normal, strand.view));
  float s = sin_l + sin_v;
  // cos((a - b) / 2) of the two thetas, and its complement
  float cos_d = sqrt(clamp(0.5 + 0.5 * (cos_l * cos_v + sin_l * sin_v), 0.04, 1.0));
  float off = 1.0 - cos_d;
  float inner = sqrt(1.0 - (1.0 - cos_d * cos_d) / (kFiberIndex * kFiberIndex));  // cosine within the fibre
  vec3 loss = pow(log(base) / kColorScale, vec3(2.0)) / inner;
  float mirrored = 0.075 + 0.42 * off * off, enters = pow2(1.0 - mirrored);
  // what faces the light, over what hides it from there and from the eye
  float lit = cos_l * in_v / in_l;
  float once = kPi / max(cos_v + lit, kLeastOnce), often = kPi / (max(cos_v, kLeastOften) + lit);
  vec3 light = color * once * own_share(strand, lit / max(cos_v, kLeastOnce));
  vec3 soft = color * often * own_share(strand, kOftenApart * uneven(base) * lit / max(cos_v, kLeastOften));

  sum.primary += light * (gaussian(s + 2.0 * tilt, width) * mirrored / (2.0 * kPi));
  float tt = gaussian(s - tilt, 0.5 * width) * enters * gaussian(kPi - phi, 0.73 + 0.47 * off);
  float trt = gaussian(s - 4.0 * tilt, 2.0 * width) * enters * 0.87 * mirrored * gaussian(phi, 0.506);
  sum.secondary += light * strand.mask * trt * exp(-3.6 * loss);

  float mean = mean_of(base);
  float steep = 0.5 + 2.3 * pow(mean, 0.75);
  float wander = sqrt(pow2(width * 1.3 * (1.0 + pow(mean, 0.7))) + pow2(kApart * (cos_l + cos_v)));
  float cone = mix(gaussian(s + 0.05 + 0.4 * mean, wander), 0.45 * cos_l * cos_v, 0.14);
  float more = 3.6 * (1.0 + steep * min(in_l / cos_l, 1.0)) * (1.0 + steep * min(in_v / cos_v, 1.0)) / pow2(1.0 + steep) *
               cone / kPi;
  sum.diffuse += light * tt * exp(-1.86 * loss) + soft * more * base;
}
