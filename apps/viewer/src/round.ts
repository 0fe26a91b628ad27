// The surface of round volumes: centre ± core0 ± core1 + Σ d_i · axis_i with |d| = 1. That of a ball is cut into four, which
// a core pulls apart; what lies between is flat or straight.
import { BufferAttribute, BufferGeometry } from 'three';

interface Template {
  ways: number[]; // d of each vertex
  sides: [number, number][]; // on which side of each core it is
  triangles: number[];
}

/// A template has so many rings around, and four times `quarter` columns.
function template(rings: number, quarter: number): Template {
  const made: Template = { ways: [], sides: [], triangles: [] };
  const columns = 4 * (quarter + 1);
  for (let ring = 0; ring <= rings; ++ring)
    for (let column = 0; column < columns; ++column) {
      const part = Math.floor(column / (quarter + 1));
      const longitude = ((part + (column % (quarter + 1)) / quarter) * Math.PI) / 2;
      const latitude = (ring / rings - 0.5) * Math.PI;
      made.ways.push(Math.cos(latitude) * Math.cos(longitude), Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude));
      made.sides.push([part === 0 || part === 3 ? 1 : -1, part < 2 ? 1 : -1]);
    }
  const at = (ring: number, column: number) => ring * columns + (column % columns);
  for (let ring = 0; ring < rings; ++ring)
    for (let column = 0; column < columns; ++column) {
      const [a, b, c, d] = [at(ring, column), at(ring, column + 1), at(ring + 1, column + 1), at(ring + 1, column)];
      made.triangles.push(a, b, c, a, c, d);
    }
  for (const ring of [0, rings]) {
    const [a, b, c, d] = [0, 1, 2, 3].map((part) => at(ring, part * (quarter + 1)));
    made.triangles.push(a, b, c, a, c, d);
  }
  return made;
}

const cross = (a: number[], b: number[]) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/// A mesh of all volumes, 18 numbers each, one after the other; and how many triangles one of them has.
export function roundSurfaces(numbers: Float32Array): { geometry: BufferGeometry; vertices: number; triangles: number } {
  const count = numbers.length / 18;
  const { ways, sides, triangles } = count > 100 ? template(6, 3) : template(16, 6);
  const positions = new Float32Array(count * ways.length);
  const normals = new Float32Array(count * ways.length);
  const index = new Uint32Array(count * triangles.length);
  const normal = [0, 0, 0];
  for (let volume = 0; volume < count; ++volume) {
    const [centre, u, v, x, y, z] = [0, 1, 2, 3, 4, 5].map((i) => [...numbers.subarray(18 * volume + 3 * i, 18 * volume + 3 * i + 3)]);
    const across = [cross(y, z), cross(z, x), cross(x, y)]; // normals are turned by the cofactors of the axes
    const first = volume * ways.length;
    for (let i = 0; i < ways.length; i += 3) {
      const [side, other] = sides[i / 3];
      for (let k = 0; k < 3; ++k) {
        positions[first + i + k] = centre[k] + side * u[k] + other * v[k] + ways[i] * x[k] + ways[i + 1] * y[k] + ways[i + 2] * z[k];
        normal[k] = ways[i] * across[0][k] + ways[i + 1] * across[1][k] + ways[i + 2] * across[2][k];
      }
      const length = Math.hypot(...normal);
      for (let k = 0; k < 3; ++k) normals[first + i + k] = length > 0 ? normal[k] / length : ways[i + k];
    }
    for (let i = 0; i < triangles.length; ++i) index[volume * triangles.length + i] = first / 3 + triangles[i];
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return { geometry, vertices: ways.length / 3, triangles: triangles.length / 3 };
}
