// The camera and the light for surfaces: part of every module that draws in space, which declares a uniform
// block `view` with a member `eye` of this type.
//
// The light moves with the eye, so that every view shows the shape: one source above and to the left of
// the eye, one at it, and a sky brighter than the ground. They sum to 1 where the surface faces the eye, so
// that a flat color is unchanged there. All colors are linear.

struct Eye {
    // clip = clip · (position, 1)
    clip: mat4x4<f32>,
    // normals turned so that x is right, y up, z towards the eye
    turn: mat3x3<f32>,
    // depth in the target = x + y / distance; z: how much nearer, as a part of the distance, lines on
    // the surface are drawn; w: the light's part of a color, the rest does not depend on the light
    depth: vec4<f32>,
}

const KEY: vec3<f32> = vec3<f32>(-0.42, 0.52, 0.7438);
const KEY_SHARE: f32 = 0.50;
const EYE_SHARE: f32 = 0.30;
const SKY_SHARE: f32 = 0.24;
// How far the key light extends beyond the edge of its shadow (wrap lighting).
const WRAP: f32 = 0.3;
// Strength of the sheen at the key light's reflection.
const SHEEN: f32 = 0.035;
// The light on back faces, relative to front faces.
const BACK: f32 = 0.6;

// Two 12-bit numbers of the octahedron's square in one float (Cigolle et al. 2014, "oct24").
fn unpacked_normal(packed: f32) -> vec3<f32> {
    let across = floor(packed / 4096.0);
    let square = vec2<f32>(across, packed - 4096.0 * across) / 2047.5 - 1.0;
    let z = 1.0 - abs(square.x) - abs(square.y);
    let fold = max(-z, 0.0);
    return normalize(vec3<f32>(square - select(vec2<f32>(-fold), vec2<f32>(fold), square >= vec2<f32>(0.0)), z));
}

fn amount(normal: vec3<f32>) -> f32 {
    let key = max((dot(normal, KEY) + WRAP) / (1.0 + WRAP), 0.0);
    return KEY_SHARE * key + EYE_SHARE * max(normal.z, 0.0) + SKY_SHARE * (0.5 + 0.5 * normal.y);
}

// The color in this light; `normal` is in the eye's axes and may have any length.
fn lit(colour: vec3<f32>, normal: vec3<f32>, front: bool) -> vec3<f32> {
    let outward = normalize(normal);
    let n = select(-outward, outward, front);
    let share = amount(n) / amount(vec3<f32>(0.0, 0.0, 1.0));
    let side = select(BACK, 1.0, front);
    let halfway = normalize(KEY + vec3<f32>(0.0, 0.0, 1.0));
    let sheen = SHEEN * side * pow(max(dot(n, halfway), 0.0), 48.0);
    return side * colour * mix(1.0, share, view.eye.depth.w) + sheen * view.eye.depth.w;
}

// The same position, slightly nearer to the eye.
fn lifted(clip: vec4<f32>) -> vec4<f32> {
    let far = view.eye.depth.x * clip.w;
    return vec4<f32>(clip.xy, far + (clip.z - far) / (1.0 - view.eye.depth.z), clip.w);
}
