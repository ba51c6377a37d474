#!/usr/bin/env python3
"""Writes slice.tif, a slice as a micro-CT scanner might give it, of a rock that is a stated random process.

Grains are discs of one radius whose centres are a Poisson process (Boolean model, Stoyan, Kendall & Mecke 1995): with n
centres per area the porosity is exp(-n pi r^2) in the mean. Grey values are 9000 in pores and 41000 in grains, blurred by a
Gauss function of 0.8 pixels, with normal noise of 2500, in 16 bits; the file says that pixels are 5 micrometres. The same
seed gives the same picture. Needs numpy and Pillow.
"""
import math
import pathlib

import numpy as np
from PIL import Image

COLUMNS, ROWS, PIXEL = 400, 280, 5e-6  # m
RADIUS, POROSITY, SEED = 13, 0.45, 4  # pixels
PORE, GRAIN, BLUR, NOISE = 9000, 41000, 0.8, 2500


def grains(random):
    """True in a grain; centres lie up to a radius outside of the picture."""
    width, height = COLUMNS + 2 * RADIUS, ROWS + 2 * RADIUS
    count = random.poisson(-math.log(POROSITY) / (math.pi * RADIUS**2) * width * height)
    x, y = np.meshgrid(np.arange(COLUMNS) + 0.5, np.arange(ROWS) + 0.5)
    solid = np.zeros((ROWS, COLUMNS), dtype=bool)
    for cx, cy in random.random((count, 2)) * (width, height) - RADIUS:
        solid |= (x - cx) ** 2 + (y - cy) ** 2 < RADIUS**2
    return solid


def blurred(values):
    reach = np.arange(-4, 5)
    weights = np.exp(-0.5 * (reach / BLUR) ** 2)
    weights /= weights.sum()
    for axis in (0, 1):
        padded = np.pad(values, [(4, 4) if a == axis else (0, 0) for a in (0, 1)], mode="edge")
        values = sum(w * np.take(padded, np.arange(values.shape[axis]) + k, axis) for k, w in enumerate(weights))
    return values


def main():
    random = np.random.Generator(np.random.PCG64(SEED))
    grey = blurred(np.where(grains(random), GRAIN, PORE).astype(float)) + NOISE * random.standard_normal((ROWS, COLUMNS))
    grey = 256 * np.rint(np.clip(grey, 0, 65535) / 256).clip(0, 255)  # steps of 256 keep the file small
    dots = 0.01 / PIXEL  # per centimetre
    path = pathlib.Path(__file__).with_name("slice.tif")
    Image.fromarray(grey.astype(np.uint16)).save(path, compression="tiff_adobe_deflate", resolution_unit=3,
                                                 x_resolution=dots, y_resolution=dots)
    print(path, f"porosity {(grey < 25000).mean():.3f}")


main()
