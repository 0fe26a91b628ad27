// The objects: each mesh is drawn once for all objects that share it, and once more for those that are ghosts; where there are
// many meshes they are drawn together: a card that is a program takes milliseconds for each drawing, whatever is in it.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  MeshLambertMaterial,
  Object3D,
  Points,
  PointsMaterial,
  Raycaster,
  Sphere,
  Vector3,
  type Camera,
  type Scene,
  type WebGLRenderer,
} from 'three';
import { heavy } from './coarse';
import { Copies, Crowd, CrowdPart, type Drawing, type Member } from './crowd';
import type { Header, MeshHeader, PageData } from './data';
import { matrixOf, shownPlace, stored } from './place';

/// Around three numbers each; three.js asks for every one of them by itself, which takes a second for a million.
function boxOf(numbers: Float32Array | Uint16Array): Box3 {
  const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < numbers.length; at += 3)
    for (let axis = 0; axis < 3; ++axis) {
      const number = numbers[at + axis];
      if (number < lower[axis]) lower[axis] = number;
      if (number > upper[axis]) upper[axis] = number;
    }
  return new Box3(new Vector3().fromArray(lower), new Vector3().fromArray(upper));
}

/// Six times what a closed mesh encloses; below 0 where it is inside out.
function volumeOf(geometry: BufferGeometry): number {
  const p = geometry.getAttribute('position').array, corners = geometry.getIndex()!.array;
  let volume = 0;
  for (let at = 0; at < corners.length; at += 3) {
    const [a, b, c] = [3 * corners[at], 3 * corners[at + 1], 3 * corners[at + 2]];
    volume += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return volume;
}

export type Look = 'shown' | 'ghost' | 'hidden';

export interface Appearance {
  look: Look;
  colour: number;
  ghostColour?: number;
}

/// The same objects, as those that are shown and as ghosts.
type Drawings = Record<'shown' | 'ghost', Drawing>;

/// Where there are so many objects, those of so few triangles, and those whose mesh is of no other and that never move, are
/// drawn together.
const joined = { triangles: 600, objects: 32, vertices: 4_000_000 };

const isFew = (corners: number) => corners <= 3 * joined.triangles;

function canBeJoined(groups: Member[][]): boolean {
  const all = groups.flat();
  const vertices = all.reduce((sum, { geometry }) => sum + geometry.getAttribute('position').count, 0);
  return all.length >= joined.objects && vertices <= joined.vertices;
}

export class Objects {
  readonly group = new Group();
  readonly matrices: Matrix4[];
  readonly boxes: Box3[];
  private readonly geometries: BufferGeometry[];
  private readonly drawings: Drawings[] = [];
  private readonly thin = new Map<number, LineSegments | Points>();
  private readonly crowds: Crowd[] = [];
  private readonly moved = new Set<number>(); // since they were drawn
  private readonly solidMaterials: MeshLambertMaterial[] = [];
  private readonly closed: { material: MeshLambertMaterial; members: Member[] }[] = []; // of closed meshes alone
  private closedMaterials: MeshLambertMaterial[] | undefined; // of those none of which shows its back; made when it is first wanted
  private readonly triangles: number;

  constructor(private readonly data: PageData) {
    const { header, report } = data;
    this.matrices = header.objects.map(({ mesh, fit }, i) => matrixOf(shownPlace(header.frame, report.objects[i].pose, stored(header.meshes[mesh]), fit)));
    this.geometries = header.meshes.map((mesh) => this.geometryOf(mesh));
    this.boxes = header.objects.map(({ mesh }, i) => (this.geometries[mesh].boundingBox ?? new Box3()).clone().applyMatrix4(this.matrices[i]));
    this.addDrawings(header);
    this.triangles = this.drawings.reduce((sum, { shown }) => sum + shown.triangles, 0);
  }

  private geometryOf(mesh: MeshHeader): BufferGeometry {
    const geometry = new BufferGeometry();
    const vertices = mesh.vertices.bytes === 2 ? this.data.shorts(mesh.vertices) : this.data.floats(mesh.vertices);
    geometry.setAttribute('position', new BufferAttribute(vertices, 3));
    const triangles = mesh.triangles.bytes === 2 ? this.data.shorts(mesh.triangles) : this.data.integers(mesh.triangles);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    if (mesh.smooth) geometry.computeVertexNormals();
    geometry.boundingBox = boxOf(vertices);
    geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new Sphere());
    return geometry;
  }

  private addDrawings(header: Header): void {
    const members: Member[][] = header.meshes.map(() => []);
    header.objects.forEach(({ mesh }, object) => members[mesh].push({ object, geometry: this.geometries[mesh], matrix: this.matrices[object] }));
    const crowds: Record<'smooth' | 'flat', Member[][]> = { smooth: [], flat: [] };
    header.meshes.forEach((mesh, i) => {
      if (mesh.triangles.count === 0) for (const { object, geometry } of members[i]) this.addThin(object, geometry);
      else if (isFew(mesh.triangles.count) || (members[i].length === 1 && !header.motion)) crowds[mesh.smooth ? 'smooth' : 'flat'].push(members[i]);
      else this.addCopies(members[i], mesh.smooth);
    });
    for (const kind of ['smooth', 'flat'] as const) this.addJoined(crowds[kind], kind === 'smooth');
  }

  /// All of them together, or, where these are too large, the small ones.
  private addJoined(groups: Member[][], smooth: boolean): void {
    const small = groups.filter(([{ geometry }]) => isFew(geometry.getIndex()!.count));
    const together = new Set([groups, small].find(canBeJoined));
    for (const group of groups) if (!together.has(group)) this.addCopies(group, smooth);
    if (together.size === 0) return;
    const crowd = new Crowd([...together].flat(), smooth);
    this.crowds.push(crowd);
    this.add({ shown: new CrowdPart(crowd, this.material(smooth, false)), ghost: new CrowdPart(crowd, this.material(smooth, true)) }, crowd.members);
  }

  private addCopies(members: Member[], smooth: boolean): void {
    if (members.length === 0) return;
    this.add({ shown: new Copies(members, this.material(smooth, false)), ghost: new Copies(members, this.material(smooth, true)) }, members);
  }

  private add(drawings: Drawings, members: Member[]): void {
    if (members.every(({ object }) => this.data.report.objects[object].closed))
      this.closed.push({ material: drawings.shown.drawn.material as MeshLambertMaterial, members });
    drawings.ghost.drawn.renderOrder = 1;
    this.group.add(drawings.shown.drawn, drawings.ghost.drawn);
    this.drawings.push(drawings);
  }

  private material(smooth: boolean, ghost: boolean): MeshLambertMaterial {
    const material = new MeshLambertMaterial({ side: DoubleSide, flatShading: !smooth, forceSinglePass: true });
    if (ghost) return Object.assign(material, { transparent: true, opacity: 0.1, depthWrite: false });
    this.solidMaterials.push(material);
    return Object.assign(material, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  }

  /// Points and segments, which have no triangles.
  private addThin(object: number, geometry: BufferGeometry): void {
    const plain = new BufferGeometry().setAttribute('position', geometry.getAttribute('position'));
    const count = plain.getAttribute('position').count;
    const drawn: LineSegments | Points =
      count > 1 ? new LineSegments(plain, new LineBasicMaterial()) : new Points(plain, new PointsMaterial({ size: 8, sizeAttenuation: false }));
    drawn.matrixAutoUpdate = false;
    drawn.matrix.copy(this.matrices[object]);
    this.thin.set(object, drawn);
    this.group.add(drawn);
  }

  /// Has the graphics card make its programs, while the page does other things.
  prepare(renderer: WebGLRenderer, camera: Camera, scene: Scene): void {
    for (const { shown } of this.drawings) renderer.compile(shown.drawn, camera, scene);
  }

  /// Whether there are so many triangles that a program in place of a graphics card takes long to draw them.
  get isHeavy(): boolean {
    return this.triangles > heavy;
  }

  /// About how many triangles of all objects together are drawn (undefined: all), and whether the backs of what is closed are.
  setDetail(triangles: number | undefined, backs = true): void {
    const share = triangles === undefined ? undefined : triangles / this.triangles;
    for (const { shown, ghost } of this.drawings) for (const drawing of [shown, ghost]) drawing.setCoarse(share);
    if (backs && !this.closedMaterials) return;
    const showsFront = ({ geometry, matrix }: Member) => volumeOf(geometry) * matrix.determinant() > 0;
    this.closedMaterials ??= this.closed.filter(({ members }) => members.every(showsFront)).map(({ material }) => material);
    for (const material of this.closedMaterials) {
      const side = backs ? DoubleSide : FrontSide;
      if (material.side === side) continue;
      material.side = side;
      material.needsUpdate = true;
    }
  }

  /// One appearance for each object.
  show(looks: Appearance[], ghostColour: number): void {
    for (const crowd of this.crowds) crowd.replace(this.moved);
    this.moved.clear();
    for (const drawing of this.drawings) {
      drawing.shown.fill((i) => looks[i].look === 'shown', (i) => looks[i].colour);
      drawing.ghost.fill((i) => looks[i].look === 'ghost', (i) => looks[i].ghostColour ?? ghostColour);
    }
    for (const [object, drawn] of this.thin) {
      drawn.visible = looks[object].look !== 'hidden';
      (drawn.material as LineBasicMaterial).color.set(looks[object].colour);
    }
  }

  seeThrough(on: boolean): void {
    for (const material of this.solidMaterials) {
      material.transparent = on;
      material.opacity = on ? 0.45 : 1;
      material.depthWrite = !on;
      material.needsUpdate = true;
    }
  }

  /// The object under a ray, and where; objects that are shown before ghosts. What is cut away is not there.
  hit(ray: Raycaster, isThere: (point: Vector3) => boolean = () => true): { object: number; point: Vector3 } | undefined {
    for (const part of ['shown', 'ghost'] as const) {
      let best: { object: number; point: Vector3; distance: number } | undefined;
      for (const drawings of this.drawings) {
        const drawing = drawings[part];
        if (!drawing.drawn.visible) continue;
        drawing.prepareRays();
        for (const found of ray.intersectObject(drawing.drawn, false))
          if (isThere(found.point) && (!best || found.distance < best.distance)) best = { object: drawing.objectAt(found), point: found.point, distance: found.distance };
      }
      if (best) return best;
    }
    return undefined;
  }

  /// A drawing of some triangles of an object, over it.
  trianglesOf(object: number, triangles: Uint32Array): BufferGeometry {
    const geometry = this.geometries[this.data.header.objects[object].mesh];
    const all = geometry.getIndex();
    const chosen = new Uint32Array(triangles.length * 3);
    triangles.forEach((triangle, i) => {
      for (let corner = 0; corner < 3; ++corner) chosen[3 * i + corner] = all?.getX(3 * triangle + corner) ?? 0;
    });
    const part = new BufferGeometry().setAttribute('position', geometry.getAttribute('position'));
    return part.setIndex(new BufferAttribute(chosen, 1));
  }

  /// Places an object elsewhere; `show` draws it there.
  moveTo(object: number, pose: number[]): void {
    const { header } = this.data;
    const { mesh, fit } = header.objects[object];
    this.setMatrix(object, matrixOf(shownPlace(header.frame, pose, stored(header.meshes[mesh]), fit)));
  }

  /// From the numbers of its mesh to what is shown.
  setMatrix(object: number, matrix: Matrix4): void {
    const { mesh } = this.data.header.objects[object];
    this.moved.add(object);
    this.matrices[object].copy(matrix);
    this.boxes[object].copy((this.geometries[mesh].boundingBox ?? new Box3()).clone().applyMatrix4(this.matrices[object]));
    this.thin.get(object)?.matrix.copy(this.matrices[object]);
  }

  place(drawn: Object3D, object: number): void {
    drawn.matrixAutoUpdate = false;
    drawn.matrix.copy(this.matrices[object]);
  }
}
