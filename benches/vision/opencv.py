"""Colour segmentation by OpenCV: YUYV to HSV, a mask for each of five classes, connected components of each mask.

python3 opencv.py FOLDER [--threads]: processes the files NAME-WIDTHxHEIGHT.yuyv of the folder, each a sequence of frames. Prints for
each file the mean over the frames of the minimum time of several rounds, µs: first with connectedComponents, then with
connectedComponentsWithStats, which also measures the components. Uses one thread, or with --threads as many as OpenCV chooses.
All results are written to memory that is already allocated.
"""

import signal

# Ctrl-C ends the program without a traceback, also during the imports below.
signal.signal(signal.SIGINT, signal.SIG_DFL)

import pathlib
import sys
import time

import cv2
import numpy as np

ROUNDS = 5
# Interval of the frames that are processed; consecutive frames are similar.
STEP = 4
# Hue 0 to 180, saturation, value: orange, yellow, blue, white, green.
CLASSES = [
    ((3, 100, 60), (16, 255, 255)),
    ((20, 90, 60), (34, 255, 255)),
    ((95, 60, 40), (125, 255, 255)),
    ((0, 0, 130), (180, 50, 255)),
    ((35, 30, 30), (94, 255, 200)),
]


class Buffers:
    def __init__(self, width, height):
        self.bgr = np.empty((height, width, 3), np.uint8)
        self.hsv = np.empty((height, width, 3), np.uint8)
        self.mask = np.empty((height, width), np.uint8)
        self.labels = np.empty((height, width), np.int32)

    def segment(self, frame, components):
        cv2.cvtColor(frame, cv2.COLOR_YUV2BGR_YUYV, self.bgr)
        cv2.cvtColor(self.bgr, cv2.COLOR_BGR2HSV, self.hsv)
        for low, high in CLASSES:
            cv2.inRange(self.hsv, low, high, self.mask)
            components(self.mask, self.labels)


def plain(mask, labels):
    cv2.connectedComponents(mask, labels, 8, cv2.CV_32S)


def with_stats(mask, labels):
    cv2.connectedComponentsWithStats(mask, labels, connectivity=8, ltype=cv2.CV_32S)


def mean_of_minima(buffers, frames, components):
    minima = [float("inf")] * len(frames)
    for _ in range(ROUNDS):
        for at, frame in enumerate(frames):
            began = time.perf_counter_ns()
            buffers.segment(frame, components)
            minima[at] = min(minima[at], time.perf_counter_ns() - began)
    return sum(minima) / len(minima) / 1e3


def main():
    cv2.setNumThreads(-1 if "--threads" in sys.argv else 1)
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*.yuyv"), key=lambda path: path.stat().st_size):
        width, height = map(int, path.stem.rsplit("-", 1)[1].split("x"))
        frames = np.fromfile(path, np.uint8).reshape(-1, height, width, 2)[::STEP]
        buffers = Buffers(width, height)
        figures = [mean_of_minima(buffers, frames, components) for components in (plain, with_stats)]
        print(path.stem, *(f"{figure:.1f}" for figure in figures))
    print("version", cv2.__version__, file=sys.stderr)


main()
