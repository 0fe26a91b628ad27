// How objects are drawn: copies of one mesh, or many small ones joined.
import { BufferAttribute, BufferGeometry, Color, InstancedMesh, Matrix3, Matrix4, Mesh, Vector3, type Intersection, type Material, type Object3D } from 'three';

export interface Member {
  object: number;
  geometry: BufferGeometry;
  matrix: Matrix4;
}

/// What draws some objects in one call for those that are shown, and one for ghosts.
export interface Drawing {
  readonly drawn: Object3D;
  fill(isDrawn: (object: number) => boolean, colourOf: (object: number) => number): void;
  objectAt(hit: Intersection): number;
  prepareRays(): void;
}

/// Copies of one mesh, which the graphics card places.
export class Copies implements Drawing {
  readonly drawn: InstancedMesh;
  private listed: number[] = [];

  constructor(
    private readonly members: Member[],
    material: Material,
  ) {
    this.drawn = new InstancedMesh(members[0].geometry, material, members.length);
    this.drawn.setColorAt(0, new Color());
    this.drawn.frustumCulled = false;
  }

  fill(isDrawn: (object: number) => boolean, colourOf: (object: number) => number): void {
    const { drawn } = this;
    const colour = new Color();
    const shown = this.members.filter(({ object }) => isDrawn(object));
    this.listed = shown.map(({ object }) => object);
    shown.forEach(({ object, matrix }, place) => {
      drawn.setMatrixAt(place, matrix);
      drawn.setColorAt(place, colour.set(colourOf(object)));
    });
    drawn.count = this.listed.length;
    drawn.visible = drawn.count > 0;
    drawn.instanceMatrix.needsUpdate = true;
    if (drawn.instanceColor) drawn.instanceColor.needsUpdate = true;
  }

  objectAt(hit: Intersection): number {
    return this.listed[hit.instanceId ?? 0];
  }

  prepareRays(): void {
    this.drawn.computeBoundingSphere();
  }
}

/// The vertices of many small objects at their places, once for what is shown and what is a ghost. A card that is a
/// program draws copies one after the other, and thousands of them take seconds; this it draws at once.
export class Crowd {
  readonly positions: BufferAttribute;
  readonly normals: BufferAttribute | undefined;
  readonly colours: BufferAttribute;
  readonly firstOf = new Map<number, number>();

  constructor(readonly members: Member[], smooth: boolean) {
    let vertices = 0;
    for (const { object, geometry } of members) {
      this.firstOf.set(object, vertices);
      vertices += geometry.getAttribute('position').count;
    }
    this.positions = new BufferAttribute(new Float32Array(3 * vertices), 3);
    this.colours = new BufferAttribute(new Float32Array(3 * vertices), 3);
    if (smooth) this.normals = new BufferAttribute(new Float32Array(3 * vertices), 3);
    for (const member of members) this.place(member);
  }

  /// Puts those objects where their matrices say now.
  replace(objects: Set<number>): void {
    const moved = this.members.filter(({ object }) => objects.has(object));
    if (moved.length === 0) return;
    for (const member of moved) this.place(member);
    this.positions.needsUpdate = true;
    if (this.normals) this.normals.needsUpdate = true;
  }

  private place({ object, geometry, matrix }: Member): void {
    const [position, normal] = [geometry.getAttribute('position'), geometry.getAttribute('normal')];
    const first = this.firstOf.get(object)!;
    const turned = new Matrix3().getNormalMatrix(matrix);
    const v = new Vector3();
    for (let i = 0; i < position.count; ++i) {
      v.fromBufferAttribute(position, i).applyMatrix4(matrix).toArray(this.positions.array, 3 * (first + i));
      if (this.normals) v.fromBufferAttribute(normal, i).applyNormalMatrix(turned).toArray(this.normals.array, 3 * (first + i));
    }
  }
}

export class CrowdPart implements Drawing {
  readonly drawn: Mesh;
  private ends: number[] = []; // of the triangles of each object that is drawn
  private listed: number[] = [];

  constructor(
    private readonly crowd: Crowd,
    material: Material,
  ) {
    const geometry = new BufferGeometry().setAttribute('position', crowd.positions).setAttribute('color', crowd.colours);
    if (crowd.normals) geometry.setAttribute('normal', crowd.normals);
    material.vertexColors = true;
    this.drawn = new Mesh(geometry, material);
    this.drawn.frustumCulled = false;
  }

  fill(isDrawn: (object: number) => boolean, colourOf: (object: number) => number): void {
    const shown = this.crowd.members.filter(({ object }) => isDrawn(object));
    const index = new Uint32Array(shown.reduce((sum, { geometry }) => sum + geometry.getIndex()!.count, 0));
    this.listed = shown.map(({ object }) => object);
    this.ends = [];
    let at = 0;
    for (const { object, geometry } of shown) {
      const first = this.crowd.firstOf.get(object)!;
      for (const corner of geometry.getIndex()!.array) index[at++] = first + corner;
      this.ends.push(at / 3);
      this.paint(first, geometry.getAttribute('position').count, new Color(colourOf(object)));
    }
    this.drawn.geometry.setIndex(new BufferAttribute(index, 1));
    this.drawn.visible = index.length > 0;
    this.crowd.colours.needsUpdate = true;
  }

  private paint(first: number, count: number, colour: Color): void {
    for (let i = first; i < first + count; ++i) colour.toArray(this.crowd.colours.array, 3 * i);
  }

  objectAt(hit: Intersection): number {
    const triangle = hit.faceIndex ?? 0;
    let [low, high] = [0, this.ends.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.ends[middle] <= triangle) low = middle + 1;
      else high = middle;
    }
    return this.listed[low];
  }

  prepareRays(): void {
    this.drawn.geometry.computeBoundingSphere();
  }
}
