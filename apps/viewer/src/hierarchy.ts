// A level of a hierarchy: every volume in a colour of its own, and the triangles that it holds in the same.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial, Raycaster, type Object3D } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { stepColours, type Theme } from './colours';
import type { HierarchyLayer, LayerStep, PageData } from './data';
import type { Objects } from './objects';
import { matrixOf, shownPlace } from './place';

/// What can be asked about a level that is drawn.
export interface DrawnLevel {
  layer: HierarchyLayer;
  step: LayerStep;
  volumes: Mesh;
}

/// The colours of nodes, one after the other for each of `corners` vertices.
function coloursOf(nodes: Uint32Array, corners: number): Float32Array {
  const palette = stepColours.map((hex) => new Color(hex));
  const colours = new Float32Array(nodes.length * corners * 3);
  nodes.forEach((node, i) => {
    const colour = palette[node % palette.length];
    for (let corner = 0; corner < corners; ++corner) colour.toArray(colours, (i * corners + corner) * 3);
  });
  return colours;
}

function drawnVolumes(layer: HierarchyLayer, step: LayerStep, data: PageData): Mesh {
  const [first, count] = step.faces ?? [0, 0];
  const nodes = data.integers(layer.node_of_face).subarray(first, first + count);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(data.floats(layer.faces).subarray(first * 9, (first + count) * 9), 3));
  geometry.setAttribute('color', new BufferAttribute(coloursOf(nodes, 3), 3));
  const material = new MeshLambertMaterial({
    vertexColors: true,
    transparent: true,
    opacity: 0.16,
    depthWrite: false,
    side: DoubleSide,
    flatShading: true,
  });
  const drawn = new Mesh(geometry, material);
  drawn.frustumCulled = false;
  drawn.renderOrder = 3;
  return drawn;
}

function drawnEdges(layer: HierarchyLayer, step: LayerStep, data: PageData): Object3D {
  const [first, count] = step.edges ?? [0, 0];
  if (count === 0) return new Group();
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(data.floats(layer.edges).subarray(first * 6, (first + count) * 6));
  geometry.setColors(coloursOf(data.integers(layer.node_of_edge).subarray(first, first + count), 2));
  const drawn = new LineSegments2(geometry, new LineMaterial({ vertexColors: true, linewidth: 1.6 }));
  drawn.frustumCulled = false;
  drawn.renderOrder = 4;
  return drawn;
}

/// The triangles of one node of the level, as numbers of the mesh.
export function trianglesHeld(layer: HierarchyLayer, step: LayerStep, node: number, data: PageData): Uint32Array {
  const runs = data.integers(layer.data);
  const [first, count] = [runs[2 * (step.first + node)], runs[2 * (step.first + node) + 1]];
  return data.integers(layer.order).subarray(first, first + count);
}

/// All triangles of the object, coloured by the node that holds them.
function colouredTriangles(layer: HierarchyLayer, step: LayerStep, data: PageData, objects: Objects): Object3D {
  const order = data.integers(layer.order);
  const nodes = new Uint32Array(order.length);
  const runs = data.integers(layer.data);
  for (let node = 0; node < step.count; ++node) {
    const first = runs[2 * (step.first + node)];
    nodes.fill(node, first, first + runs[2 * (step.first + node) + 1]);
  }
  const geometry = objects.trianglesOf(layer.object, order).toNonIndexed();
  geometry.setAttribute('color', new BufferAttribute(coloursOf(nodes, 3), 3));
  const drawn = new Mesh(geometry, new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, flatShading: true }));
  drawn.frustumCulled = false;
  drawn.renderOrder = 1;
  objects.place(drawn, layer.object);
  return drawn;
}

export function drawLevel(layer: HierarchyLayer, step: LayerStep, data: PageData, objects: Objects): { drawn: Object3D; level: DrawnLevel } {
  const volumes = drawnVolumes(layer, step, data);
  const boxes = new Group().add(volumes, drawnEdges(layer, step, data));
  const { size, lower } = layer;
  boxes.matrixAutoUpdate = false;
  boxes.matrix.copy(matrixOf(shownPlace(data.header.frame, data.report.objects[layer.object].pose, [size, 0, 0, 0, size, 0, 0, 0, size, ...lower])));
  return { drawn: new Group().add(boxes, colouredTriangles(layer, step, data, objects)), level: { layer, step, volumes } };
}

/// The smallest node of the level whose volume a ray meets.
export function nodeUnder(level: DrawnLevel, ray: Raycaster, data: PageData): number | undefined {
  const nodes = data.integers(level.layer.node_of_face);
  const first = level.step.faces?.[0] ?? 0;
  const hits = ray.intersectObject(level.volumes, false).map((hit) => nodes[first + (hit.faceIndex ?? 0)]);
  const held = (node: number) => trianglesHeld(level.layer, level.step, node, data).length;
  return hits.length === 0 ? undefined : hits.reduce((best, node) => (held(node) < held(best) ? node : best));
}

/// The triangles of a node, lit.
export function litTriangles(level: DrawnLevel, node: number, data: PageData, objects: Objects, theme: Theme): Object3D {
  const held = trianglesHeld(level.layer, level.step, node, data);
  const material = new MeshBasicMaterial({ color: theme.contact, side: DoubleSide, transparent: true, opacity: 0.8, depthTest: false });
  const drawn = new Mesh(objects.trianglesOf(level.layer.object, held), material);
  drawn.frustumCulled = false;
  drawn.renderOrder = 5;
  objects.place(drawn, level.layer.object);
  return drawn;
}
