
# (support point, value, weight) for each term
@if f@
const _F = [
@f@
]
@end@

@if f_inverse@
const _F_INVERSE = [
@f_inverse@
]
@end@

function _rational(table, z)
    numerator = denominator = complex(0.0, 0.0)
    for (point, value, weight) in table
        difference = z - point
        abs(difference) < 1e-150 && return value
        term = weight / difference
        numerator += term * value
        denominator += term
    end
    return numerator / denominator
end

@if f@
"The image of the point z of the source, a complex number."
f(z::Number) = _rational(_F, ComplexF64(z))
@end@

@if f_inverse@
"The point of the source whose image is the point w of the target, a complex number."
f_inverse(w::Number) = _rational(_F_INVERSE, ComplexF64(w))
@end@
