// Places in double precision: the 12 numbers of a pose, R row by row and then t.
import { Matrix4 } from 'three';
import type { Header, MeshHeader, Vec } from './data';

export type Numbers12 = number[];

export const identity: Numbers12 = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

export function apply(m: Numbers12, v: Vec): Vec {
  return [
    m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[9],
    m[3] * v[0] + m[4] * v[1] + m[5] * v[2] + m[10],
    m[6] * v[0] + m[7] * v[1] + m[8] * v[2] + m[11],
  ];
}

/// `outer` after `inner`.
export function compose(outer: Numbers12, inner: Numbers12): Numbers12 {
  const result: Numbers12 = [];
  for (let row = 0; row < 3; ++row)
    for (let column = 0; column < 3; ++column)
      result.push(
        outer[3 * row] * inner[column] + outer[3 * row + 1] * inner[3 + column] + outer[3 * row + 2] * inner[6 + column],
      );
  return [...result, ...apply(outer, [inner[9], inner[10], inner[11]])];
}

/// World coordinates to those that are drawn.
export function worldToShown(frame: Header['frame']): (m: Numbers12) => Numbers12 {
  const { centre, size } = frame;
  return (m) => [...m.slice(0, 9).map((x) => x / size), ...[0, 1, 2].map((i) => (m[9 + i] - centre[i]) / size)];
}

/// The numbers of a mesh's vertices to its own frame.
export function stored(mesh: MeshHeader): Numbers12 {
  const { lower, step } = mesh.vertices;
  return [step[0], 0, 0, 0, step[1], 0, 0, 0, step[2], ...lower];
}

export function matrixOf(m: Numbers12): Matrix4 {
  return new Matrix4().set(m[0], m[1], m[2], m[9], m[3], m[4], m[5], m[10], m[6], m[7], m[8], m[11], 0, 0, 0, 1);
}
