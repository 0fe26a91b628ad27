// The ground grid, and the bar that tells how long things are.
import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, type Box3, type Object3D } from 'three';
import type { Theme } from './colours';
import type { Header } from './data';

/// 1, 2 or 5 times a power of ten, at most `length`.
export function roundLength(length: number): number {
  const power = Math.max(10 ** Math.floor(Math.log10(length)), Number.MIN_VALUE);
  return length >= 5 * power ? 5 * power : length >= 2 * power ? 2 * power : power;
}

/// Below the scene, in world steps of 1, 2 or 5 times a power of ten.
export function gridLines(header: Header, box: Box3, theme: Theme): Object3D {
  const { centre, size } = header.frame;
  const [u, v, up] = header.up === 'z' ? [0, 1, 2] : [2, 0, 1];
  const extent = Math.max(box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z, 1e-6);
  const step = roundLength((extent / 8) * size);
  const spacing = step / size; // first divided, as the lengths themselves may be beyond the doubles
  const low = box.min.getComponent(up);
  const numbers: number[] = [];
  const colours: number[] = [];
  const add = (along: number, across: number, at: number, from: number, to: number, axis: boolean) => {
    const colour = new Color(axis ? theme.gridAxis : theme.grid);
    for (const end of [from, to]) {
      const point = [0, 0, 0];
      point[along] = end;
      point[across] = at;
      point[up] = low;
      numbers.push(...point);
      colours.push(colour.r, colour.g, colour.b);
    }
  };
  const lines = (across: number, along: number) => {
    const margin = extent * 0.5;
    const from = box.min.getComponent(along) - margin;
    const to = box.max.getComponent(along) + margin;
    const first = Math.ceil((box.min.getComponent(across) - margin + centre[across] / size) / spacing);
    const last = Math.floor((box.max.getComponent(across) + margin + centre[across] / size) / spacing);
    for (let i = first; i <= last && i - first < 200; ++i) add(along, across, i * spacing - centre[across] / size, from, to, i === 0);
  };
  lines(u, v);
  lines(v, u);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(numbers), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
  const drawn = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
  drawn.frustumCulled = false;
  return drawn;
}
