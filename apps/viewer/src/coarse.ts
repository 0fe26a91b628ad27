// What is drawn in place of a mesh while the picture moves, where all of its triangles would take too long: the box of the
// mesh in cells, the vertices of each cell as one, and the triangles that are left.
import { BufferAttribute, BufferGeometry } from 'three';

/// From how many triangles of all objects together on there is something coarse.
export const heavy = 300_000;

/// What is drawn while the picture moves: about so many triangles of all objects together, such a share of many points, how fine
/// on the screen, and whether the backs of closed meshes, too. Each is for what is too slow for the one before.
export const levels = [
  { triangles: 24_000, points: 1, fineness: 1 / 2, backs: true },
  { triangles: 10_000, points: 1 / 2, fineness: 1 / 3, backs: true },
  { triangles: 4_000, points: 1 / 4, fineness: 1 / 4, backs: false },
];

export type Numbers = Float32Array | Uint16Array;

/// So few cells have vertices that lie far apart, and the outermost stands for all, so that what is long stays so.
const fewCells = 3;

/// The number of each vertex's cell, and a vertex of each cell that has some; there are `cells` along each side of the box.
function cellsOf(numbers: Numbers, lower: number[], upper: number[], cells: number): { of: Uint32Array; first: number[] } {
  const scale = [0, 1, 2].map((axis) => (upper[axis] > lower[axis] ? cells / (upper[axis] - lower[axis]) : 0));
  const numberOf = new Int32Array(cells ** 3).fill(-1);
  const first: number[] = [], howFar: number[] = [];
  const of = new Uint32Array(numbers.length / 3);
  for (let vertex = 0; vertex < of.length; ++vertex) {
    let place = 0;
    for (let axis = 0; axis < 3; ++axis) {
      const cell = ((numbers[3 * vertex + axis] - lower[axis]) * scale[axis]) | 0; // whole numbers are what takes least
      place = place * cells + (cell < cells ? cell : cells - 1);
    }
    if (numberOf[place] < 0) numberOf[place] = first.push(vertex) - 1;
    of[vertex] = numberOf[place];
    if (cells > fewCells) continue;
    let far = 0; // from the middle of the box
    for (let axis = 0; axis < 3; ++axis) far += Math.abs((numbers[3 * vertex + axis] - lower[axis]) * scale[axis] - cells / 2);
    if (far <= (howFar[of[vertex]] ?? 0)) continue;
    first[of[vertex]] = vertex;
    howFar[of[vertex]] = far;
  }
  return { of, first };
}

/// Whether a triangle is told for the first time, by the numbers of three different cells.
function firstTold(cells: number): (a: number, b: number, c: number) => boolean {
  const bits = cells ** 3 <= 1 << 18 ? new Uint8Array(cells ** 3) : undefined; // many meshes have few cells each
  const seen = new Set<number>();
  return (a, b, c) => {
    const least = Math.min(a, b, c), most = Math.max(a, b, c);
    const key = (least * cells + (a + b + c - least - most)) * cells + most;
    if (bits ? bits[key] === 1 : seen.has(key)) return false;
    if (bits) bits[key] = 1;
    else seen.add(key);
    return true;
  };
}

/// The triangles between three cells, each once, over the same vertices: about so many.
export function coarseOf(geometry: BufferGeometry, triangles: number): BufferGeometry {
  const { min, max } = geometry.boundingBox!;
  // A surface that fills its box meets some 4n² of n³ cells.
  const cells = Math.min(200, Math.max(2, Math.round(Math.sqrt(triangles / 4))));
  const { of, first } = cellsOf(geometry.getAttribute('position').array as Numbers, min.toArray(), max.toArray(), cells);
  const corners = geometry.getIndex()!.array;
  const kept: number[] = [];
  const isNew = firstTold(first.length);
  for (let at = 0; at < corners.length; at += 3) {
    const a = of[corners[at]], b = of[corners[at + 1]], c = of[corners[at + 2]];
    if (a !== b && b !== c && c !== a && isNew(a, b, c)) kept.push(first[a], first[b], first[c]);
  }
  const coarse = new BufferGeometry().setAttribute('position', geometry.getAttribute('position'));
  if (geometry.hasAttribute('normal')) coarse.setAttribute('normal', geometry.getAttribute('normal'));
  coarse.setIndex(new BufferAttribute(new Uint32Array(kept), 1));
  coarse.boundingBox = geometry.boundingBox;
  coarse.boundingSphere = geometry.boundingSphere;
  return coarse;
}
