// To be pasted into a shader of GLSL 3.30, or ES 3.00 with "precision highp float;".

@if f@
@f@
@end@

@if f_inverse@
@f_inverse@
@end@

// a/b of complex numbers
vec2 riemap_divide(vec2 a, vec2 b) {
    return vec2(dot(a, b), a.y * b.x - a.x * b.y) / dot(b, b);
}

// a b of complex numbers
vec2 riemap_multiply(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

@if f@
// The image of the point z of the source.
vec2 f(vec2 z) {
    vec2 numerator = vec2(0.0), denominator = vec2(0.0);
    for (int k = 0; k < F_COUNT; k++) {
        vec2 difference = z - F_SUPPORT[k];
        if (dot(difference, difference) < 1e-30) return F_VALUES[k];
        vec2 term = riemap_divide(F_WEIGHTS[k], difference);
        numerator += riemap_multiply(term, F_VALUES[k]);
        denominator += term;
    }
    return riemap_divide(numerator, denominator);
}
@end@

@if f_inverse@
// The point of the source whose image is the point w of the target.
vec2 f_inverse(vec2 w) {
    vec2 numerator = vec2(0.0), denominator = vec2(0.0);
    for (int k = 0; k < F_INVERSE_COUNT; k++) {
        vec2 difference = w - F_INVERSE_SUPPORT[k];
        if (dot(difference, difference) < 1e-30) return F_INVERSE_VALUES[k];
        vec2 term = riemap_divide(F_INVERSE_WEIGHTS[k], difference);
        numerator += riemap_multiply(term, F_INVERSE_VALUES[k]);
        denominator += term;
    }
    return riemap_divide(numerator, denominator);
}
@end@
