// How objects are drawn: copies of one mesh, or many small ones joined.
import { BufferAttribute, BufferGeometry, Color, InstancedMesh, Matrix3, Matrix4, Mesh, Sphere, Vector3, type Intersection, type Material } from 'three';
import { coarseOf, type Numbers } from './coarse';

export interface Member {
  object: number;
  geometry: BufferGeometry;
  matrix: Matrix4;
}

/// What draws some objects in one call for those that are shown, and one for ghosts.
export interface Drawing {
  readonly drawn: Mesh;
  fill(isDrawn: (object: number) => boolean, colourOf: (object: number) => number): void;
  objectAt(hit: Intersection): number;
  prepareRays(): void;
  readonly triangles: number; // of all objects
  setCoarse(share: number | undefined): void; // about so much of the triangles; undefined: all
}

const trianglesOf = (geometry: BufferGeometry) => (geometry.getIndex()?.count ?? 0) / 3;

const fewest = 12; // triangles, below which a mesh stays what it is

/// The mesh itself, where it has few triangles or most of them are wanted.
function withShare(geometry: BufferGeometry, share: number): BufferGeometry {
  const wanted = Math.max(fewest, share * trianglesOf(geometry));
  return 2 * wanted >= trianglesOf(geometry) ? geometry : coarseOf(geometry, wanted);
}

/// Copies of one mesh, which the graphics card places.
export class Copies implements Drawing {
  readonly drawn: InstancedMesh;
  private listed: number[] = [];
  private readonly whole: BufferGeometry;
  private coarse: { share: number; geometry: BufferGeometry } | undefined; // made when it is first drawn

  constructor(
    private readonly members: Member[],
    material: Material,
  ) {
    this.whole = members[0].geometry;
    this.drawn = new InstancedMesh(this.whole, material, members.length);
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

  get triangles(): number {
    return this.members.length * trianglesOf(this.whole);
  }

  setCoarse(share: number | undefined): void {
    if (share !== undefined && this.coarse?.share !== share) this.coarse = { share, geometry: withShare(this.whole, share) };
    this.drawn.geometry = share === undefined ? this.whole : this.coarse!.geometry;
  }

  prepareRays(): void {
    this.setCoarse(undefined);
    this.drawn.computeBoundingSphere();
  }
}

/// The vertices of many objects at their places, once for what is shown and what is a ghost. A card that is a
/// program draws copies one after the other, and thousands of them take seconds; this it draws at once.
export class Crowd {
  readonly positions: BufferAttribute;
  readonly normals: BufferAttribute | undefined;
  readonly colours: BufferAttribute;
  readonly firstOf = new Map<number, number>();
  private readonly coarser = new Map<BufferGeometry, BufferGeometry>(); // of about this share
  private share = 1;

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

  /// With about so much of its triangles: made once, as long as that is what is asked.
  coarse(geometry: BufferGeometry, share: number): BufferGeometry {
    if (share !== this.share) this.coarser.clear();
    this.share = share;
    const found = this.coarser.get(geometry) ?? withShare(geometry, share);
    this.coarser.set(geometry, found);
    return found;
  }

  private place({ object, geometry, matrix }: Member): void {
    const [position, normal] = [geometry.getAttribute('position'), geometry.getAttribute('normal')];
    const first = this.firstOf.get(object)!;
    // Number by number: three.js's vectors take ten times as long for half a million vertices.
    const numbers = position.array as Numbers;
    const placed = this.positions.array;
    const e = matrix.elements;
    for (let from = 0, to = 3 * first; from < numbers.length; from += 3, to += 3) {
      const x = numbers[from], y = numbers[from + 1], z = numbers[from + 2];
      for (let row = 0; row < 3; ++row) placed[to + row] = e[row] * x + e[4 + row] * y + e[8 + row] * z + e[12 + row];
    }
    if (!this.normals) return;
    const turned = new Matrix3().getNormalMatrix(matrix);
    const v = new Vector3();
    for (let i = 0; i < position.count; ++i) v.fromBufferAttribute(normal, i).applyNormalMatrix(turned).toArray(this.normals.array, 3 * (first + i));
  }
}

/// What is drawn of the members that are listed: all of their triangles, or fewer.
interface Joined {
  geometry: BufferGeometry;
  ends: number[]; // of the triangles of each object that is drawn
  isFilled: boolean;
  share?: number; // of all triangles
}

export class CrowdPart implements Drawing {
  readonly drawn: Mesh;
  private listed: Member[] = [];
  private readonly joined: Record<'whole' | 'coarse', Joined>;
  private share: number | undefined; // of the triangles that are drawn

  constructor(
    private readonly crowd: Crowd,
    material: Material,
  ) {
    const empty = () => {
      const geometry = new BufferGeometry().setAttribute('position', crowd.positions).setAttribute('color', crowd.colours);
      if (crowd.normals) geometry.setAttribute('normal', crowd.normals);
      geometry.boundingSphere = new Sphere(); // nothing asks for it but rays, and three.js would look at all corners
      return { geometry, ends: [], isFilled: false };
    };
    this.joined = { whole: empty(), coarse: empty() };
    material.vertexColors = true;
    this.drawn = new Mesh(this.joined.whole.geometry, material);
    this.drawn.frustumCulled = false;
  }

  fill(isDrawn: (object: number) => boolean, colourOf: (object: number) => number): void {
    this.listed = this.crowd.members.filter(({ object }) => isDrawn(object));
    for (const { object, geometry } of this.listed)
      this.paint(this.crowd.firstOf.get(object)!, geometry.getAttribute('position').count, new Color(colourOf(object)));
    this.crowd.colours.needsUpdate = true;
    this.drawn.visible = this.listed.length > 0;
    this.joined.whole.isFilled = this.joined.coarse.isFilled = false;
    this.setCoarse(this.share);
  }

  get triangles(): number {
    return this.crowd.members.reduce((sum, { geometry }) => sum + trianglesOf(geometry), 0);
  }

  setCoarse(share: number | undefined): void {
    const joined = this.joined[share === undefined ? 'whole' : 'coarse'];
    if (share !== undefined && share !== joined.share) joined.isFilled = false;
    this.share = joined.share = share;
    this.drawn.geometry = joined.geometry;
    if (joined.isFilled) return;
    const indices = this.listed.map(({ object, geometry }) => ({
      first: this.crowd.firstOf.get(object)!,
      corners: (share === undefined ? geometry : this.crowd.coarse(geometry, share)).getIndex()!.array,
    }));
    const index = new Uint32Array(indices.reduce((sum, { corners }) => sum + corners.length, 0));
    joined.ends = [];
    let at = 0;
    for (const { first, corners } of indices) {
      for (let i = 0; i < corners.length; ++i) index[at++] = first + corners[i];
      joined.ends.push(at / 3);
    }
    joined.geometry.setIndex(new BufferAttribute(index, 1));
    joined.isFilled = true;
  }

  private paint(first: number, count: number, colour: Color): void {
    const { array } = this.crowd.colours;
    const { r, g, b } = colour;
    for (let at = 3 * first; at < 3 * (first + count); at += 3) {
      array[at] = r;
      array[at + 1] = g;
      array[at + 2] = b;
    }
  }

  objectAt(hit: Intersection): number {
    const triangle = hit.faceIndex ?? 0;
    const { ends } = this.joined.whole;
    let [low, high] = [0, ends.length - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (ends[middle] <= triangle) low = middle + 1;
      else high = middle;
    }
    return this.listed[low].object;
  }

  prepareRays(): void {
    this.setCoarse(undefined);
    this.drawn.geometry.computeBoundingSphere();
  }
}
