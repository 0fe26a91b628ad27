// How each kind of layer is drawn (docs/reference/view-page.md). A new kind is one entry of `kinds`.
import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  NotEqualStencilFunc,
  Object3D,
  Points,
  PointsMaterial,
  ReplaceStencilOp,
} from 'three';
import type { Layer, LayerStep, PageData } from './data';
import { bodyColours, eventColours, facesA, facesB, stepColours, type Theme } from './colours';
import type { Objects } from './objects';
import { bodies, cells, links } from './moving';
import { identity, matrixOf, shownPlace } from './place';
import { arrows, strokes } from './strokes';

export interface LayerStyle {
  theme: Theme;
  over: boolean; // drawn over everything, for a finding that is looked at
  arrow: number; // how long arrows are
  second?: number; // B of the finding
  through: boolean; // bodies let what is within them be seen
  step?: LayerStep;
  stepNumber: number;
}

interface Drawing {
  data: PageData;
  objects: Objects;
}

type Draw = (layer: Layer, drawing: Drawing, style: LayerStyle) => Object3D;

/// The colours of what `inspect` found out of order.
const faultColours = (theme: Theme) => ({
  boundary_edges: theme.depth,
  non_manifold_edges: theme.normal,
  flipped_edges: theme.distance,
  degenerate_triangles: theme.contact,
  duplicate_triangles: theme.within,
  unused_vertices: theme.contact,
});

export function roleColour(theme: Theme, role: string, stepNumber = 0): number {
  const ofRole = { ...theme, ...faultColours(theme), pairs: theme.contact, bodies: bodyColours[1], begin: eventColours.begin, persist: theme.contact, end: eventColours.end } as unknown as Record<string, number>;
  return ofRole[role] ?? stepColours[stepNumber % stepColours.length];
}

/// What goes on through moments keeps its colour.
const colourOf = (layer: Layer, style: LayerStyle) => roleColour(style.theme, layer.role, layer.moments ? 0 : style.stepNumber);

/// The numbers of the layer, or of its step; `width` numbers make an item.
function numbersOf(layer: Layer, { data }: Drawing, style: LayerStyle, width: number): Float32Array {
  const all = data.floats(layer.data);
  return style.step ? all.subarray(style.step.first * width, (style.step.first + style.step.count) * width) : all;
}

/// All items, where the layer has neither steps nor moments.
const stepOf = (layer: Layer, style: LayerStyle, width: number) => style.step ?? { label: '', first: 0, count: layer.data.count / width };

/// What lies behind surfaces is drawn so faintly.
export const behind = 0.28;

export function segments(numbers: Float32Array, colour: number, width: number, over: boolean): Object3D {
  return strokes(numbers, width, { colour, order: over ? 4 : 2, hidden: over ? behind : 0 });
}

let disc: CanvasTexture | undefined;

function discTexture(): CanvasTexture {
  if (disc) return disc;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const context = canvas.getContext('2d');
  if (context) {
    context.fillStyle = '#fff';
    context.arc(16, 16, 14, 0, 2 * Math.PI);
    context.fill();
  }
  disc = new CanvasTexture(canvas);
  return disc;
}

export function points(numbers: Float32Array, colour: number, over: boolean, size = 8): Object3D {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(numbers, 3));
  const material = new PointsMaterial({
    color: colour,
    size,
    sizeAttenuation: false,
    map: discTexture(),
    alphaTest: 0.5,
    depthTest: !over,
    transparent: over,
  });
  const drawn = new Points(geometry, material);
  drawn.frustumCulled = false;
  drawn.renderOrder = over ? 5 : 2;
  return drawn;
}

const fewPoints = 500;

/// Of points that are more than a few, such a share is drawn, from all over them.
export function thinOut(drawn: Object3D, share: number): void {
  if (!(drawn instanceof Points)) return;
  const { count } = drawn.geometry.getAttribute('position');
  if (share === 1 || count <= fewPoints) drawn.geometry.setIndex(null);
  else drawn.geometry.setIndex(Array.from({ length: Math.floor(share * count) }, (_, i) => Math.floor(i / share)));
}

/// The triangles of an object that a finding is about.
const faces: Draw = (layer, { data, objects }, style) => {
  const object = layer.object ?? 0;
  const colour = layer.finding === undefined ? colourOf(layer, style) : style.second === object ? facesB : facesA;
  const material = new MeshLambertMaterial({ color: colour, side: DoubleSide, flatShading: true });
  const drawn = new Mesh(objects.trianglesOf(object, data.integers(layer.data)), material);
  drawn.frustumCulled = false;
  drawn.renderOrder = 1;
  objects.place(drawn, object);
  return drawn;
};

const triangles: Draw = (layer, drawing, style) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(numbersOf(layer, drawing, style, 9), 3));
  const material = new MeshBasicMaterial({
    color: colourOf(layer, style),
    side: DoubleSide,
    transparent: true,
    opacity: 0.35,
    depthTest: !style.over,
    depthWrite: false,
    forceSinglePass: true, // else three.js draws both sides one after the other
    // A surface is made of parts that reach into each other: every point of the screen takes its colour once.
    stencilWrite: layer.role === 'surface',
    stencilRef: 1,
    stencilFunc: NotEqualStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });
  const drawn = new Mesh(geometry, material);
  drawn.frustumCulled = false;
  drawn.renderOrder = 3;
  return drawn;
};

/// The twelve edges of boxes, each its lower and its upper corner in the frame of the layer's object.
const boxes: Draw = (layer, drawing, style) => {
  const numbers = numbersOf(layer, drawing, style, 6);
  const edges = new Float32Array((numbers.length / 6) * 72);
  let at = 0;
  for (let i = 0; i < numbers.length; i += 6)
    for (let axis = 0; axis < 3; ++axis)
      for (let side = 0; side < 4; ++side)
        for (let end = 0; end < 2; ++end)
          for (let k = 0; k < 3; ++k) {
            const upper = k === axis ? end : k === (axis + 1) % 3 ? side & 1 : side >> 1;
            edges[at++] = numbers[i + k + 3 * upper];
          }
  const drawn = segments(edges, colourOf(layer, style), 1.25, false);
  if (layer.object !== undefined) {
    const { header, report } = drawing.data;
    drawn.matrixAutoUpdate = false;
    drawn.matrix.copy(matrixOf(shownPlace(header.frame, report.objects[layer.object].pose, identity)));
  }
  return drawn;
};

export const kinds: Record<string, Draw> = {
  segments: (layer, drawing, style) => segments(numbersOf(layer, drawing, style, 6), colourOf(layer, style), layer.role === 'contact' ? 3 : 4, style.over),
  points: (layer, drawing, style) => points(numbersOf(layer, drawing, style, 3), colourOf(layer, style), style.over),
  triangles,
  arrows: (layer, drawing, style) => arrows(numbersOf(layer, drawing, style, 6), style.arrow, { colour: colourOf(layer, style), order: 4, hidden: behind }),
  faces,
  boxes,
  bodies: (layer, { data }, style) => bodies(layer, data, stepOf(layer, style, 7), style.through),
  cells: (layer, { data }, style) => cells(layer, data, stepOf(layer, style, 7)),
  links: (layer, { data }, style) => links(layer, data, stepOf(layer, style, 2), style.stepNumber, style.theme),
};

export function draw(layer: Layer, drawing: Drawing, style: LayerStyle): Object3D {
  const kind = kinds[layer.kind];
  if (!kind) throw new Error(`this page cannot show a layer of the kind ${layer.kind}`);
  const drawn = kind(layer, drawing, style);
  drawn.name = layer.kind; // for tests
  return drawn;
}

/// All layers of one kind and role in one drawing.
export function merged(layers: Layer[], data: PageData): Float32Array {
  const parts = layers.map((layer) => data.floats(layer.data));
  const whole = new Float32Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

const mostCurves = 20_000; // segments

/// Whether the curves of all contacts are more than can be drawn together, and told apart.
export function areManyCurves(data: PageData): boolean {
  let count = 0;
  for (const layer of data.foundOf('contact', 'segments')) count += layer.data.count / 6;
  return count > mostCurves;
}

/// For each layer the middle of the box around its points.
export function middles(layers: Layer[], data: PageData): Float32Array {
  const all = new Float32Array(3 * layers.length);
  layers.forEach((layer, i) => {
    const numbers = data.floats(layer.data);
    for (let axis = 0; axis < 3; ++axis) {
      let lower = Infinity, upper = -Infinity;
      for (let at = axis; at < numbers.length; at += 3) {
        if (numbers[at] < lower) lower = numbers[at];
        if (numbers[at] > upper) upper = numbers[at];
      }
      all[3 * i + axis] = (lower + upper) / 2;
    }
  });
  return all;
}

/// What a drawing holds on the graphics card is given back.
export function discard(drawn: Object3D): void {
  drawn.traverse((part) => {
    const { geometry, material } = part as Mesh;
    geometry?.dispose?.();
    (material as MeshBasicMaterial | undefined)?.dispose?.();
  });
  drawn.removeFromParent();
}

