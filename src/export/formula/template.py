
# (support point, value, weight) for each term
@if f@
_F = (
@f@
)
@end@

@if f_inverse@
_F_INVERSE = (
@f_inverse@
)
@end@


def _rational(table, z):
    numerator = denominator = 0j
    for point, value, weight in table:
        difference = z - point
        if abs(difference) < 1e-150:
            return value
        term = weight / difference
        numerator += term * value
        denominator += term
    return numerator / denominator


@if f@
def f(z):
    """The image of the point z of the source, a complex number."""
    return _rational(_F, complex(z))
@end@


@if f_inverse@
def f_inverse(w):
    """The point of the source whose image is the point w of the target, a complex number."""
    return _rational(_F_INVERSE, complex(w))
@end@


@if f@
if __name__ == "__main__":
    import sys

    # python3 THIS_FILE X Y: prints f(X + iY)
    if len(sys.argv) == 3:
        image = f(complex(float(sys.argv[1]), float(sys.argv[2])))
        print(image.real, image.imag)
@end@
