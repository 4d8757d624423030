"""Made meshes that stand in for the models of Sun 2012 and Xu 2014: holes with the printed boundaries. Needs numpy and scipy."""
import numpy as np
from scipy.spatial import ConvexHull

import filler_bench
import surfaces

RATIOS = np.geomspace(1, 16, 13)  # long over short half axes of a hole
SCALES = np.linspace(.6, 1.25, 27)  # of its size, to meet the boundary
ATTEMPTS = 40


def boundary_of(triangles, removed):
    """The edges around what is removed, if that is one disc."""
    return len(surfaces.boundary(triangles[removed])) if removed.any() and filler_bench.one_disc(triangles[removed]) else 0


def inside_of(triangles, removed):
    """How many vertices a disc of triangles has inside: its triangles are its edges around + 2 of these - 2."""
    return (removed.sum() - boundary_of(triangles, removed) + 2) // 2


def half_axes(rim, ratio):
    """Of an ellipse with about so many edges around."""
    short = rim / (np.pi * (3 * (1 + ratio) - np.sqrt((3 + ratio) * (1 + 3 * ratio))))
    return short * ratio, short


def leaf(rim, inside):
    """A curved sheet (filler_bench.make) with a hole of exactly `rim` edges, as long as its removed vertices come nearest to `inside`."""
    best = None
    for attempt in range(ATTEMPTS):
        rng = np.random.default_rng([rim, inside, attempt])
        points, triangles = filler_bench.sheet(int(np.ceil(rim / 4 + filler_bench.MARGIN)), rng)
        u, v = points[triangles].mean(1).T
        for ratio in RATIOS:
            along, across = half_axes(rim, ratio)
            for scale in SCALES:
                removed = np.hypot(u / along, v / across) < scale
                if boundary_of(triangles, removed) != rim:
                    continue
                off = abs(inside_of(triangles, removed) - inside)
                if best is None or off < best[0]:
                    best = off, (filler_bench.curved(*points.T, scale * np.sqrt(along * across)), triangles, removed, scale * np.sqrt(along * across))
        if best and best[0] <= .05 * inside:
            break
    return best[1]


# Radius 1 by direction: closed surfaces, the last two with a head's details.
HEADS = {'sphere': lambda d: np.ones(len(d)),
         'ellipsoid': lambda d: 1 / np.sqrt((d[:, 0] / .8) ** 2 + (d[:, 1] / .95) ** 2 + (d[:, 2] / 1.2) ** 2),
         'ripples': lambda d: 1 + .03 * np.sin(9 * d[:, 0] + 2) * np.cos(8 * d[:, 1]),
         'bumps': lambda d: 1 + .06 * np.sin(5 * d[:, 0] + 1) + .05 * np.cos(6 * d[:, 1] + .5) * np.sin(4 * d[:, 2])}


def directions(n, rng):
    """Unit vectors, about even."""
    k = np.arange(n) + .5
    polar, around = np.arccos(1 - 2 * k / n), np.pi * (1 + 5 ** .5) * k
    points = np.stack([np.cos(around) * np.sin(polar), np.sin(around) * np.sin(polar), np.cos(polar)], 1)
    points += rng.normal(0, .06 * np.sqrt(4 * np.pi / n), points.shape)
    return points / np.linalg.norm(points, axis=1)[:, None]


def outward(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    inward = np.einsum('ij,ij->i', np.cross(b - a, c - a), a) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return triangles


def head(kind, vertices, seed, rim, radius=100):
    """Points, triangles, which of them are removed, the radius: a closed surface with a round hole of exactly `rim` edges."""
    rng = np.random.default_rng([seed, vertices])
    points = directions(vertices, rng)
    triangles = outward(points, ConvexHull(points).simplices)
    middle = points[triangles].mean(1)
    for _ in range(200):
        axis = rng.normal(size=3)
        off = np.linalg.norm(middle - axis / np.linalg.norm(axis), axis=1)
        for reach in np.linspace(2, 4, 30) * np.sqrt(4 * np.pi / vertices):
            if boundary_of(triangles, off < reach) == rim:
                return radius * points * HEADS[kind](points)[:, None], triangles, off < reach, radius
    raise SystemExit(f'no hole of {rim} edges')


def to_head(kind, points, radius=100):
    """The distance of points from the analytic surface, to first order."""
    def excess(p):
        length = np.linalg.norm(p, axis=1)
        return length - HEADS[kind](p / length[:, None])
    p, h = points / radius, 1e-5
    slope = np.stack([(excess(p + h * e) - excess(p - h * e)) / (2 * h) for e in np.eye(3)], 1)
    return radius * np.abs(excess(p)) / np.linalg.norm(slope, axis=1)


def area_of(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
