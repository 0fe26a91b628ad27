// A level of a hierarchy: every volume in a colour of its own, and the triangles that it holds in the same.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Raycaster,
  ShaderMaterial,
  type Object3D,
} from 'three';
import { stepColours, type Theme } from './colours';
import type { ArrayPlace, FlatHierarchy, HierarchyLayer, LayerStep, PageData } from './data';
import type { Objects } from './objects';
import { matrixOf, shownPlace } from './place';
import { roundSurfaces } from './round';

/// What can be asked about a level that is drawn.
export interface DrawnLevel {
  layer: HierarchyLayer;
  step: LayerStep;
  volumes: Volumes;
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

/// Faces are faint and the lines of a polyhedron strong, both in one drawing: `corner` tells how far a point of a triangle is
/// from each of its sides, and 1 for sides that are no edges.
const flatShaders = {
  vertexShader: `
    attribute vec3 corner;
    varying vec3 vColor, vCorner, vPlace;
    void main() {
      vColor = color;
      vCorner = corner;
      vec4 place = modelViewMatrix * vec4(position, 1.0);
      vPlace = place.xyz;
      gl_Position = projectionMatrix * place;
    }`,
  fragmentShader: `
    varying vec3 vColor, vCorner, vPlace;
    void main() {
      vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
      vec3 pixel = fwidth(vCorner);
      vec3 away = smoothstep(pixel * 0.7, pixel * 1.7, vCorner);
      float line = 1.0 - min(away.x, min(away.y, away.z));
      vec3 lit = vColor * (0.65 + 0.35 * abs(normal.z));
      gl_FragColor = vec4(mix(lit, vColor * 0.85, line), mix(0.16, 1.0, line));
      #include <colorspace_fragment>
    }`,
};

/// Round volumes are strong where they turn away.
const roundShaders = {
  vertexShader: `
    varying vec3 vColor, vNormal, vPlace;
    void main() {
      vColor = color;
      vNormal = normalMatrix * normal;
      vec4 place = modelViewMatrix * vec4(position, 1.0);
      vPlace = place.xyz;
      gl_Position = projectionMatrix * place;
    }`,
  fragmentShader: `
    varying vec3 vColor, vNormal, vPlace;
    void main() {
      float facing = abs(dot(normalize(vNormal), normalize(vPlace)));
      float rim = pow(1.0 - facing, 3.0);
      gl_FragColor = vec4(vColor * (0.65 + 0.35 * facing), mix(0.16, 0.95, rim));
      #include <colorspace_fragment>
    }`,
};

function volumeMesh(geometry: BufferGeometry, shaders: { vertexShader: string; fragmentShader: string }): Mesh {
  const material = new ShaderMaterial({ ...shaders, vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide, forceSinglePass: true });
  const drawn = new Mesh(geometry, material);
  drawn.frustumCulled = false;
  drawn.renderOrder = 3;
  return drawn;
}

/// How far the three corners of each face are from its sides that are edges.
function cornersOf(edges: Uint16Array): Float32Array {
  const corners = new Float32Array(edges.length * 9);
  edges.forEach((sides, face) => {
    for (let corner = 0; corner < 3; ++corner)
      for (let side = 0; side < 3; ++side) {
        const isOff = corner === (side + 2) % 3; // of the corners of a triangle, the one that the side does not touch
        corners[9 * face + 3 * corner + side] = isOff || ((sides >> side) & 1) === 0 ? 1 : 0;
      }
  });
  return corners;
}

interface Volumes {
  mesh: Mesh;
  nodeOf: (face: number) => number;
}

function flatVolumes(layer: FlatHierarchy, step: LayerStep, data: PageData): Volumes {
  const [first, count] = step.faces ?? [0, 0];
  const nodes = data.integers(layer.node_of_face).subarray(first, first + count);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(data.floats(layer.faces).subarray(first * 9, (first + count) * 9), 3));
  geometry.setAttribute('color', new BufferAttribute(coloursOf(nodes, 3), 3));
  geometry.setAttribute('corner', new BufferAttribute(cornersOf(data.shorts(layer.edges_of_face).subarray(first, first + count)), 3));
  return { mesh: volumeMesh(geometry, flatShaders), nodeOf: (face) => nodes[face] };
}

function roundVolumes(rounds: ArrayPlace, step: LayerStep, data: PageData): Volumes {
  const numbers = data.floats(rounds).subarray(18 * step.first, 18 * (step.first + step.count));
  const { geometry, vertices, triangles } = roundSurfaces(numbers);
  const nodes = new Uint32Array(step.count).map((_, i) => i);
  geometry.setAttribute('color', new BufferAttribute(coloursOf(nodes, vertices), 3));
  return { mesh: volumeMesh(geometry, roundShaders), nodeOf: (face) => Math.floor(face / triangles) };
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

/// The volumes, and the object in the colours of those that hold its triangles.
export function drawLevel(layer: HierarchyLayer, step: LayerStep, data: PageData, objects: Objects): { drawn: Object3D; object: Object3D; level: DrawnLevel } {
  const volumes = 'rounds' in layer ? roundVolumes(layer.rounds, step, data) : flatVolumes(layer, step, data);
  const { size, lower } = layer;
  const inner = [size, 0, 0, 0, size, 0, 0, 0, size, ...lower];
  volumes.mesh.matrixAutoUpdate = false;
  volumes.mesh.matrix.copy(matrixOf(shownPlace(data.header.frame, data.report.objects[layer.object].pose, inner)));
  return { drawn: volumes.mesh, object: colouredTriangles(layer, step, data, objects), level: { layer, step, volumes } };
}

/// The smallest node of the level whose volume a ray meets.
export function nodeUnder(level: DrawnLevel, ray: Raycaster, data: PageData): number | undefined {
  const hits = ray.intersectObject(level.volumes.mesh, false).map((hit) => level.volumes.nodeOf(hit.faceIndex ?? 0));
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
