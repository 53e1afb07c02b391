"""Writes schwarz_christoffel.csv: polygons f(disk), f'(w) = prod (1 - w/w_k)^(a_k - 1), f(0) = 0, f'(0) = 1.

Each side's integral from 0 to w_k is taken with 1 - t = s^(1/a_k), which removes the singularity, to 30 digits.
Lines: "kind name", then "corner angle_of_w_k x y" in order, then "point re im x y |f'|" with w = re + i im.
"""
import random
from mpmath import mp, mpf, mpc, quad, exp, pi, fabs

mp.dps = 30
POINTS = [(0, 0), (0.3, 0.2)]


def derivative(w, corners, skip=None):
    product = mpc(1)
    for j, (angle, a) in enumerate(corners):
        if j != skip:
            product *= (1 - w * exp(mpc(0, -angle))) ** (a - 1)
    return product


def corner(k, corners):
    angle, a = corners[k]
    w = exp(mpc(0, angle))
    return w / a * quad(lambda s: derivative(w * (1 - s ** (1 / a)), corners, k), [0, mpf(1) / 4, mpf(1) / 2, 1])


def crosses(p, q, r, s):
    side = lambda a, b, c: ((b - a).conjugate() * (c - a)).imag
    return side(p, q, r) * side(p, q, s) <= 0 and side(r, s, p) * side(r, s, q) <= 0


def write(kind, name, corners):
    corners = [(mpf(angle), mpf(a)) for angle, a in corners]
    assert fabs(sum(1 - a for _, a in corners) - 2) < mpf(10) ** -20, name
    places = [corner(k, corners) for k in range(len(corners))]
    n = len(places)
    pairs = [(i, j) for i in range(n) for j in range(i + 2, n) if (i, j) != (0, n - 1)]
    if any(crosses(places[i], places[i + 1], places[j], places[(j + 1) % n]) for i, j in pairs):
        return False
    print(kind, name)
    for (angle, _), z in zip(corners, places):
        print("corner", mp.nstr(angle, 18), mp.nstr(z.real, 18), mp.nstr(z.imag, 18))
    for point in POINTS:
        w = mpc(*point)
        z = quad(lambda t: w * derivative(t * w, corners), [0, 1])
        print("point", *point, mp.nstr(z.real, 18), mp.nstr(z.imag, 18), mp.nstr(abs(derivative(w, corners)), 18))
    return True


def notch(degrees, half):
    """A square with a wedge cut from a side's middle; `half` is the angle of each flank on the circle."""
    w = mpf(degrees)
    right = [(mpf(5) / 10, mpf(1) / 2), (mpf(16) / 10, mpf(1) / 2)]
    mouth = (pi - half, mpf(1) / 2 + w / 360)
    below = [(2 * pi - angle, a) for angle, a in reversed(right)]
    return right + [mouth, (pi, 2 - w / 180), (pi + half, mouth[1])] + below


def needle(degrees):
    a = mpf(degrees) / 180
    return [(mpf(0), a), (2 * pi / 3, (1 - a) / 2), (4 * pi / 3, (1 - a) / 2)]


def any_polygon(generator, n):
    angles = sorted(generator.uniform(0, float(2 * pi)) for _ in range(n))
    gaps = [b - a for a, b in zip(angles, angles[1:] + [angles[0] + float(2 * pi)])]
    turns = [mpf(generator.uniform(-0.5, 0.8)) for _ in range(n - 1)]
    last = 2 - sum(turns)
    return list(zip(angles, [1 - t for t in turns + [last]])) if min(gaps) > 0.15 and fabs(last) < 0.8 else None


for degrees in ["20", "12", "8", "5", "4", "3", "2", "1", "0.5"]:
    assert write("notch", degrees, notch(degrees, mpf(3) / 4)), degrees
for degrees in ["30", "20", "12", "8", "5", "3", "2"]:
    assert write("needle", degrees, needle(degrees)), degrees
generator, done = random.Random(30), 0
while done < 14:
    found = any_polygon(generator, 3 + done // 2)
    done += bool(found and write("polygon", f"{3 + done // 2}-{done % 2}", found))
