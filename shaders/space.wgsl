// A surface seen by an eye, and its light: part of every module that draws in space, which declares a uniform
// block `view` with a member `eye` of this type.
//
// The light belongs to the eye, so that every view shows the shape: one source above the left shoulder,
// one at the eye, and a sky brighter than the ground. Its sum is 1 where the surface faces the eye: a
// flat colour arrives there as it is. All is linear.

struct Eye {
    // clip = clip · (position, 1)
    clip: mat4x4<f32>,
    // normals turned so that x is right, y up, z towards the eye
    turn: mat3x3<f32>,
    // depth in the target = x + y / distance; z: how much nearer, as a part of the distance, what
    // lies on the surface is drawn; w: the light's part of a colour, the rest does not depend on it
    depth: vec4<f32>,
}

const KEY: vec3<f32> = vec3<f32>(-0.42, 0.52, 0.7438);
const KEY_SHARE: f32 = 0.50;
const EYE_SHARE: f32 = 0.30;
const SKY_SHARE: f32 = 0.24;
// How far the key light reaches around the edge of its shadow.
const WRAP: f32 = 0.3;
// Of the sheen at the key light's reflection.
const SHEEN: f32 = 0.035;
// Back faces get this part of the light.
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

// A colour in this light; `normal` as turned to the eye, of either length.
fn lit(colour: vec3<f32>, normal: vec3<f32>, front: bool) -> vec3<f32> {
    let outward = normalize(normal);
    let n = select(-outward, outward, front);
    let share = amount(n) / amount(vec3<f32>(0.0, 0.0, 1.0));
    let side = select(BACK, 1.0, front);
    let halfway = normalize(KEY + vec3<f32>(0.0, 0.0, 1.0));
    let sheen = SHEEN * side * pow(max(dot(n, halfway), 0.0), 48.0);
    return side * colour * mix(1.0, share, view.eye.depth.w) + sheen * view.eye.depth.w;
}

// The same place a little nearer to the eye.
fn lifted(clip: vec4<f32>) -> vec4<f32> {
    let far = view.eye.depth.x * clip.w;
    return vec4<f32>(clip.xy, far + (clip.z - far) / (1.0 - view.eye.depth.z), clip.w);
}
