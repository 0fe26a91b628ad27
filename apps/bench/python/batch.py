"""What batch.cpp asks, from Python: `batch.py MESH.obj POSES COUNT` reads COUNT · 12 doubles (R row by row, then t) and
prints processor seconds of the batch on one thread and how many of the poses meet."""

import sys
import time

import numpy

import toccata


def main(mesh: str, file: str, count: str) -> None:
    shape = toccata.load_mesh(mesh)
    numbers = numpy.fromfile(file).reshape(int(count), 12)
    poses = numpy.tile(numpy.eye(4), (int(count), 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = numbers[:, :9].reshape(-1, 3, 3), numbers[:, 9:]
    begin = time.process_time()
    found = toccata.overlap_each(shape, shape, poses_b=poses, threads=1)
    seconds = time.process_time() - begin
    print(seconds, found.sum())


if __name__ == "__main__":
    main(*sys.argv[1:])
