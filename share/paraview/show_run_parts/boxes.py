# SPDX-License-Identifier: BSD-3-Clause
"""Boxes: lowest and highest x, y and z, one after the other."""


def union(a, b):
    return [f(a[k], b[k]) for k, f in zip(range(6), (min, max) * 3)]


def grown(bounds, share):
    result = list(bounds)
    for k in range(3):
        extra = share * (bounds[2 * k + 1] - bounds[2 * k])
        result[2 * k] -= extra
        result[2 * k + 1] += extra
    return result


def common(a, b):
    """Where two boxes overlap; the first one where they do not."""
    box = [f(a[k], b[k]) for k, f in zip(range(6), (max, min) * 3)]
    return [box[k] if box[2 * (k // 2)] <= box[2 * (k // 2) + 1] else a[k] for k in range(6)]
