// f and f_inverse take a point [x, y] and return its image [u, v]. As a script this file defines both; in Node,
// const { f, f_inverse } = require("./THIS_FILE") or import { f, f_inverse } from "./THIS_FILE".

// support point, value, weight of each term, real and imaginary parts
@if f@
const F_TERMS = [
@f@
];
@end@

@if f_inverse@
const F_INVERSE_TERMS = [
@f_inverse@
];
@end@

function rational_at(terms, [x, y]) {
  let nx = 0, ny = 0, dx = 0, dy = 0;
  for (const [zx, zy, fx, fy, wx, wy] of terms) {
    const ax = x - zx, ay = y - zy;
    if (Math.hypot(ax, ay) < 1e-150) return [fx, fy];
    // t = w/(z - z_k)
    const square = ax * ax + ay * ay;
    const tx = (wx * ax + wy * ay) / square, ty = (wy * ax - wx * ay) / square;
    nx += tx * fx - ty * fy;
    ny += tx * fy + ty * fx;
    dx += tx;
    dy += ty;
  }
  const square = dx * dx + dy * dy;
  return [(nx * dx + ny * dy) / square, (ny * dx - nx * dy) / square];
}

@if f@
/** The image [u, v] of the point [x, y] of the source. */
function f(z) {
  return rational_at(F_TERMS, z);
}
@end@

@if f_inverse@
/** The point [x, y] of the source whose image is the point [u, v] of the target. */
function f_inverse(w) {
  return rational_at(F_INVERSE_TERMS, w);
}
@end@

if (typeof module !== "undefined") {
@if f@
  module.exports.f = f;
@end@
@if f_inverse@
  module.exports.f_inverse = f_inverse;
@end@
}
