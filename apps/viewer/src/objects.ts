// The objects: each mesh is drawn once for all objects that share it, and once more for those that are ghosts.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Material,
  Matrix4,
  MeshLambertMaterial,
  Object3D,
  Points,
  PointsMaterial,
  Raycaster,
  Vector3,
} from 'three';
import type { Header, MeshHeader, PageData } from './data';
import { compose, identity, matrixOf, stored, worldToShown } from './place';

export type Look = 'shown' | 'ghost' | 'hidden';

export interface Appearance {
  look: Look;
  colour: number;
  ghostColour?: number;
}

interface DrawnMesh {
  geometry: BufferGeometry;
  objects: number[];
  solid: InstancedMesh;
  ghost: InstancedMesh;
}

export class Objects {
  readonly group = new Group();
  readonly matrices: Matrix4[];
  readonly boxes: Box3[];
  private readonly meshes: DrawnMesh[] = [];
  private readonly thin = new Map<number, LineSegments | Points>();
  private readonly ghostMaterials: MeshLambertMaterial[] = [];
  private readonly solidMaterials: MeshLambertMaterial[] = [];
  private looks: Appearance[] = [];

  constructor(private readonly data: PageData) {
    const { header, report } = data;
    const toShown = worldToShown(header.frame);
    this.matrices = header.objects.map((object, i) => {
      const placed = compose(report.objects[i].pose, object.fit ?? identity);
      return matrixOf(toShown(compose(placed, stored(header.meshes[object.mesh]))));
    });
    const members: number[][] = header.meshes.map(() => []);
    header.objects.forEach((object, i) => members[object.mesh].push(i));
    header.meshes.forEach((mesh, i) => this.addMesh(mesh, members[i]));
    this.boxes = header.objects.map((object, i) => this.boxOf(header, object.mesh, i));
  }

  private boxOf(header: Header, mesh: number, object: number): Box3 {
    const box = this.meshes[mesh].geometry.boundingBox;
    return (box ?? new Box3()).clone().applyMatrix4(this.matrices[object]);
  }

  private addMesh(mesh: MeshHeader, members: number[]): void {
    const geometry = new BufferGeometry();
    const vertices = mesh.vertices.bytes === 2 ? this.data.shorts(mesh.vertices) : this.data.floats(mesh.vertices);
    geometry.setAttribute('position', new BufferAttribute(vertices, 3));
    const triangles = mesh.triangles.bytes === 2 ? this.data.shorts(mesh.triangles) : this.data.integers(mesh.triangles);
    geometry.setIndex(new BufferAttribute(triangles, 1));
    if (mesh.smooth) geometry.computeVertexNormals();
    geometry.computeBoundingBox();
    geometry.computeBoundingSphere();
    const solid = this.instances(geometry, this.material(mesh, false), members.length);
    const ghost = this.instances(geometry, this.material(mesh, true), members.length);
    ghost.renderOrder = 1;
    this.meshes.push({ geometry, objects: members, solid, ghost });
    if (mesh.triangles.count === 0) for (const object of members) this.addThin(object, geometry);
  }

  private material(mesh: MeshHeader, ghost: boolean): MeshLambertMaterial {
    const material = new MeshLambertMaterial({ side: DoubleSide, flatShading: !mesh.smooth });
    if (ghost) Object.assign(material, { transparent: true, opacity: 0.1, depthWrite: false });
    else Object.assign(material, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    (ghost ? this.ghostMaterials : this.solidMaterials).push(material);
    return material;
  }

  private instances(geometry: BufferGeometry, material: Material, count: number): InstancedMesh {
    const mesh = new InstancedMesh(geometry, material, count);
    mesh.setColorAt(0, new Color());
    mesh.frustumCulled = false;
    this.group.add(mesh);
    return mesh;
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

  /// One appearance for each object.
  show(looks: Appearance[], ghostColour: number): void {
    this.looks = looks;
    for (const mesh of this.meshes) {
      this.fill(mesh.solid, mesh.objects.filter((i) => looks[i].look === 'shown'), (i) => looks[i].colour);
      this.fill(mesh.ghost, mesh.objects.filter((i) => looks[i].look === 'ghost'), (i) => looks[i].ghostColour ?? ghostColour);
    }
    for (const [object, drawn] of this.thin) {
      drawn.visible = looks[object].look !== 'hidden';
      (drawn.material as LineBasicMaterial).color.set(looks[object].colour);
    }
  }

  private fill(mesh: InstancedMesh, objects: number[], colourOf: (object: number) => number): void {
    const colour = new Color();
    objects.forEach((object, place) => {
      mesh.setMatrixAt(place, this.matrices[object]);
      mesh.setColorAt(place, colour.set(colourOf(object)));
    });
    mesh.count = objects.length;
    mesh.visible = objects.length > 0;
    mesh.instanceMatrix.needsUpdate = true;
    if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
  }

  seeThrough(on: boolean): void {
    for (const material of this.solidMaterials) {
      material.transparent = on;
      material.opacity = on ? 0.45 : 1;
      material.depthWrite = !on;
      material.needsUpdate = true;
    }
  }

  /// The object under a ray, and where; objects that are shown before ghosts.
  hit(ray: Raycaster): { object: number; point: Vector3 } | undefined {
    for (const part of ['solid', 'ghost'] as const) {
      let best: { object: number; point: Vector3; distance: number } | undefined;
      for (const mesh of this.meshes) {
        if (!mesh[part].visible) continue;
        mesh[part].computeBoundingSphere();
        const look = part === 'solid' ? 'shown' : 'ghost';
        const drawn = mesh.objects.filter((i) => this.looks[i].look === look);
        for (const found of ray.intersectObject(mesh[part], false))
          if (!best || found.distance < best.distance)
            best = { object: drawn[found.instanceId ?? 0], point: found.point, distance: found.distance };
      }
      if (best) return best;
    }
    return undefined;
  }

  /// A drawing of some triangles of an object, over it.
  trianglesOf(object: number, triangles: Uint32Array): BufferGeometry {
    const { geometry } = this.meshes[this.data.header.objects[object].mesh];
    const all = geometry.getIndex();
    const chosen = new Uint32Array(triangles.length * 3);
    triangles.forEach((triangle, i) => {
      for (let corner = 0; corner < 3; ++corner) chosen[3 * i + corner] = all?.getX(3 * triangle + corner) ?? 0;
    });
    const part = new BufferGeometry().setAttribute('position', geometry.getAttribute('position'));
    return part.setIndex(new BufferAttribute(chosen, 1));
  }

  place(drawn: Object3D, object: number): void {
    drawn.matrixAutoUpdate = false;
    drawn.matrix.copy(this.matrices[object]);
  }
}
