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

/// From an object's frame, or by `fit` from what is fitted into it, to what is drawn. Lengths are divided by a power of
/// two near the scene's size first, so that those near the ends of the doubles neither overflow nor are rounded away.
export function shownPlace(frame: Header['frame'], pose: Numbers12, inner: Numbers12, fit?: Numbers12): Numbers12 {
  const power = 2 ** Math.min(1023, Math.floor(Math.log2(frame.size)));
  const size = frame.size / power;
  const scaled = (m: Numbers12) => m.map((x) => x / power);
  const within = fit ? compose(scaled(fit), inner) : scaled(inner);
  const placed = compose([...pose.slice(0, 9), ...scaled(pose.slice(9))], within);
  return [...placed.slice(0, 9).map((x) => x / size), ...[0, 1, 2].map((i) => (placed[9 + i] - frame.centre[i] / power) / size)];
}

/// The numbers of a mesh's vertices to its own frame.
export function stored(mesh: MeshHeader): Numbers12 {
  const { lower, step } = mesh.vertices;
  return [step[0], 0, 0, 0, step[1], 0, 0, 0, step[2], ...lower];
}

export function matrixOf(m: Numbers12): Matrix4 {
  return new Matrix4().set(m[0], m[1], m[2], m[9], m[3], m[4], m[5], m[10], m[6], m[7], m[8], m[11], 0, 0, 0, 1);
}
