// What the engine wrote into the page (docs/reference/view-page.md), decoded.
import { visible } from './visible';

export type Vec = [number, number, number];

export interface ArrayPlace {
  at: number;
  count: number;
  bytes?: number;
}

export interface VertexPlace extends ArrayPlace {
  lower: Vec;
  step: Vec;
}

export interface MeshHeader {
  smooth: boolean;
  vertices: VertexPlace;
  triangles: ArrayPlace;
}

export interface LayerStep {
  label: string;
  note?: string;
  first: number;
  count: number;
  faces?: [number, number]; // of a hierarchy of polyhedra: the first and how many
}

export interface Layer {
  kind: string;
  role: string;
  data: ArrayPlace;
  pair?: number;
  object?: number;
  label?: string;
  length?: number | null; // written at the middle of the first segment; null: beyond the largest double
  name?: string;
  steps?: LayerStep[];
}

/// The levels of a hierarchy over a mesh (`kind` is "hierarchy"); `data` holds the run of triangles of each node.
interface Levels extends Layer {
  object: number;
  order: ArrayPlace;
  lower: Vec;
  size: number;
  steps: LayerStep[];
}

/// Of polyhedra.
export interface FlatHierarchy extends Levels {
  faces: ArrayPlace;
  node_of_face: ArrayPlace;
  edges_of_face: ArrayPlace;
}

/// Of balls, ellipsoids and swept spheres, 18 numbers each (round.ts).
export interface RoundHierarchy extends Levels {
  rounds: ArrayPlace;
}

export type HierarchyLayer = FlatHierarchy | RoundHierarchy;

export type Question = 'relation' | 'distance' | 'penetration';

export interface Header {
  format: string;
  title: string;
  up: 'y' | 'z';
  frame: { centre: Vec; size: number };
  meshes: MeshHeader[];
  objects: { mesh: number; fit?: number[]; node?: number }[];
  nodes?: { name: string; parent?: number }[]; // parents before their children
  words: { verb: string; remark: string; face_pairs?: number; methods: Partial<Record<Question, number>> }[];
  methods: string[];
  layers: Layer[];
}

/// Lengths beyond the largest double are null.
export interface Penetration {
  lower: number | null;
  upper: number | null;
  direction: Vec;
  on_a: Vec;
  on_b: Vec;
  status: string;
}

export interface Distance {
  lower: number | null;
  upper: number | null;
  on_a: Vec;
  on_b: Vec;
  face_a: number;
  face_b: number;
  status: string;
}

export interface Pair {
  a: string;
  b: string;
  a_index: number;
  b_index: number;
  relation: string;
  containment: string;
  side_unresolved: boolean;
  status: string;
  penetration?: Penetration | null;
  manifold?: { normal: Vec; points: { position: Vec; depth: number }[] } | null;
  regions?: { area: number; depth: number | null; face_pairs: number }[];
  distance?: Distance;
}

export interface ReportObject {
  name: string;
  source: string;
  shape: string;
  triangles: number;
  faces: number;
  closed: boolean;
  solid: boolean;
  group: string;
  pose: number[];
}

/// `check --json` without the faces (docs/reference/check-report.md).
export interface Report {
  schema: string;
  version: string;
  unit: string;
  warnings: string[];
  objects: ReportObject[];
  candidate_pairs: number;
  ignored_touching: number;
  clearance?: number | 'all';
  pairs: Pair[];
}

export class PageData {
  private constructor(
    readonly header: Header,
    readonly report: Report,
    private readonly bytes: Uint8Array,
  ) {}

  static read(): PageData {
    const header = JSON.parse(textOf('toccata-header'), visible) as Header;
    if (header.format !== 'toccata/view/1') throw new Error(`this page cannot show ${header.format}`);
    return new PageData(header, JSON.parse(textOf('toccata-report'), visible) as Report, bytesOf(textOf('toccata-data')));
  }

  floats(place: ArrayPlace): Float32Array {
    return new Float32Array(this.bytes.buffer, place.at, place.count);
  }

  integers(place: ArrayPlace): Uint32Array {
    return new Uint32Array(this.bytes.buffer, place.at, place.count);
  }

  shorts(place: ArrayPlace): Uint16Array {
    return new Uint16Array(this.bytes.buffer, place.at, place.count);
  }
}

function textOf(id: string): string {
  const element = document.getElementById(id);
  if (!element) throw new Error('the page holds no data: it is the empty template');
  return element.textContent ?? '';
}

function bytesOf(base64: string): Uint8Array {
  const characters = atob(base64);
  const bytes = new Uint8Array(Math.ceil(characters.length / 4) * 4);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}
