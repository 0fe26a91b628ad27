// What the engine wrote into the page (docs/reference/view-page.md), decoded.
import { parsedVisibly } from './visible';

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

/// Boxes are written in 65,535 steps.
export interface BoxesPlace extends ArrayPlace {
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
  finding?: number; // it is drawn while this one is chosen
  object?: number;
  label?: string;
  length?: number | null; // written at the middle of the first segment; null: beyond the largest double
  lower_length?: number | null; // where the length is the upper end of a bracket
  name?: string;
  steps?: LayerStep[];
  moments?: [number, number][]; // at each moment of the page's time, the first item and how many
  classes?: string[]; // what the class of a box means
  of?: number; // the layer whose items are linked
}

/// What the page's slider over time goes through.
export interface Time {
  moments: { label: string; note?: string }[];
  per_second: number; // how many are played
}

/// Where objects are at each moment: entries, those of a moment being what has changed since the one before.
export interface MotionHeader {
  objects: ArrayPlace; // whose place it is
  places: ArrayPlace; // of its own origin, in shown coordinates, 3 floats
  turns: ArrayPlace; // from its pose in the report, a quaternion in 4 signed numbers of 2 bytes; 0: it is not there
  moments: [number, number][]; // the first entry and how many
}

/// The levels of a hierarchy over a mesh (`kind` is "hierarchy"); `data` holds the run of triangles of each node.
interface Levels extends Layer {
  object: number;
  order: ArrayPlace;
  lower: Vec;
  size: number;
  steps: LayerStep[];
}

/// A hierarchy of polyhedra.
export interface FlatHierarchy extends Levels {
  faces: ArrayPlace;
  node_of_face: ArrayPlace;
  edges_of_face: ArrayPlace;
}

/// A hierarchy of balls, ellipsoids or swept spheres, 18 numbers each (round.ts).
export interface RoundHierarchy extends Levels {
  rounds: ArrayPlace;
}

export type HierarchyLayer = FlatHierarchy | RoundHierarchy;

/// The engine's words for a finding, and by which methods it was found; of faces in a region how many of which object.
export interface Words {
  verb?: string;
  remark?: string;
  face_pairs?: number | null; // null: they are too many to be drawn
  methods?: Partial<Record<'relation' | 'distance' | 'penetration' | 'cast', number>>;
  object?: number;
  faces?: number;
  triangles?: number;
  fault?: string; // of `inspect`: what kind, how many, and how many places are told together
  count?: number;
  groups?: number;
  place?: [Vec, Vec]; // of a pair: the corners of the box in which the two meet or are nearest, in the world
}

export interface Header {
  format: string;
  title: string;
  up: 'y' | 'z';
  frame: { centre: Vec; size: number };
  meshes: MeshHeader[];
  objects: { mesh: number; fit?: number[]; node?: number }[];
  nodes?: { name: string; parent?: number }[]; // parents before their children
  words: Words[];
  methods: string[];
  layers: Layer[];
  summary?: string; // in place of the count of objects and pairs
  time?: Time;
  motion?: MotionHeader;
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

/// What is known of a depth or a volume.
export interface Extent {
  lower: number;
  upper: number;
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
  regions?: Region[];
  distance?: Distance;
  clearance?: number | 'all';
  baseline?: 'new' | 'known' | 'moved' | 'graver';
  was?: { relation: string; containment: string; penetration?: Extent; local_depth?: Extent; volume?: Extent };
  moved_by?: number;
  kind?: string;
  volume?: { lower: number; upper: number; status: string } | null;
  point?: Vec | null;
  piercing?: 'unknown' | 'a_through_b' | 'b_through_a';
  tolerance?: 'within' | 'beyond' | 'undecided';
  local_depth?: { lower: number; upper: number | null };
}

/// One place at which two meshes meet.
export interface Region {
  area: number;
  depth: number | null;
  depth_upper: number | null;
  face_pairs: number;
  lower?: Vec;
  upper?: Vec;
  normal?: Vec;
}

/// A pair of the baseline that is no longer told.
export interface GonePair {
  a: string;
  b: string;
  relation: string;
  containment: string;
  reason: string;
}

/// Clashes that belong together, by their places in `pairs`.
export interface ClashGroup {
  part?: string;
  pairs: number[];
}

/// Of `--poses`; of distances it is one itself.
export interface PosesQuery {
  query: number;
  relation?: string;
  containment?: string;
  contact?: boolean;
  status: string;
  face_pairs?: number;
  penetration?: Penetration;
  regions?: unknown[];
  pose_a: number[];
  pose_b: number[];
}

export interface SelfContacts {
  object_index: number;
  triangle_pairs: number;
  face_pairs: number;
}

/// Without object_index it meets nothing.
export interface Ray {
  from: Vec;
  motion: Vec;
  object_index?: number;
  face?: number;
  upper?: number;
  point?: Vec;
  normal?: Vec;
  status: string;
}

export interface NearPoint {
  point: Vec;
  nearest: {
    object_index: number;
    face: number;
    upper: number | null;
    at: Vec;
    status: string;
    side?: string;
    side_by?: string;
    signed_upper?: number | null;
  }[];
  inside_of?: string | null;
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
  // Of `inspect`; the first few of meshes alone.
  vertices?: number;
  distinct_vertices?: number;
  components?: number;
  unbalanced_edges?: number;
  signed_volume?: number;
  world_box?: { lower: Vec; upper: Vec } | null;
  refusal?: string;
  volumes?: { volume: string; fill: number; bytes: number }[];
  partitions?: { partition: string; cells: number; items_per_cell: number; copies_per_item: number }[];
}

/// What a report leaves out of objects that are no meshes.
const plainObject = { triangles: 0, faces: 0, closed: false, solid: false, group: '' };

/// Of `cost`: one volume, arity and builder.
export interface CostRow {
  workload: string;
  volume: string;
  arity: number;
  builder: string;
  queries: number;
  N_u: number;
  N_bv: number;
  N_p: number;
  C_u_ns: number;
  C_bv_ns: number;
  C_p_ns: number;
  F_ns: number;
  measured_ns: number;
  build_ns: number;
  nodes: number;
  bytes: number;
}

/// Of `inspect --hierarchy`.
export interface TreeReport {
  nodes: number;
  leaves: number;
  depth: number;
  mean_depth: number;
  most_children: number;
  sibling_pairs: number;
  overlapping_sibling_pairs: number;
  N_bv: number;
  N_p: number;
  F: number;
}

/// Two bodies that are in contact or near, at a step of a World, or have ended to be.
export interface WorldPair {
  a_index: number;
  b_index: number;
  change: 'begin' | 'persist' | 'end';
  in_contact: boolean;
  verb?: string;
  remark?: string;
  distance?: Distance;
  penetration?: Penetration;
  points?: number;
}

/// Of `decompose`.
export interface ConvexPart {
  volume: number;
  concavity: number;
  concavity_found: number;
  vertices: Vec[];
  faces: number[][];
  source_faces: number[];
}

/// What the subcommand writes with --json (docs/reference), without the faces.
export interface Report {
  schema: string;
  version: string;
  unit: string;
  warnings: string[];
  objects: ReportObject[];
  pairs?: Pair[];
  unfinished?: number; // pairs that a check which was stopped has not looked at
  baseline?: { file: string; gone: GonePair[] };
  groups?: ClashGroup[];
  queries?: PosesQuery[];
  self_contacts?: SelfContacts[];
  rays?: Ray[];
  region?: { lower?: Vec; upper?: Vec; centre?: Vec; radius?: number };
  points?: NearPoint[];
  task?: string;
  rows?: CostRow[];
  winners?: Record<string, string[]>;
  left_out?: string[];
  as_is?: TreeReport;
  cured?: TreeReport;
  rebuilt?: TreeReport;
  named_nodes?: number;
  kept_nodes?: number;
  mesh_volume?: number;
  hull_volume?: number;
  parts?: ConvexPart[];
  operation?: string;
  dimension?: number;
  radius?: number;
  vertices?: unknown[];
  faces?: { kind: string }[];
  point?: { position: Vec; side: string };
  steps?: { pairs: WorldPair[] }[]; // of a World, by moment
  cage?: { name: string; faces: number; closed: boolean };
  gap?: { lower: number; upper: number; on_mesh: Vec; on_other: Vec; distance_to_limit: number; level: number; status: string };
  triangles?: unknown[];
  distance_to_limit?: number;
  deepest_level?: number;
  status?: string;
}

export class PageData {
  private constructor(
    readonly header: Header,
    readonly report: Report,
    private readonly bytes: ArrayBuffer,
  ) {
    for (const layer of header.layers) {
      if (layer.finding === undefined) continue;
      const kindred = this.foundOf(layer.role, layer.kind);
      if (kindred.push(layer) === 1) this.found.set(layer.role, { ...this.found.get(layer.role), [layer.kind]: kindred });
      const ofIt = this.byFinding.get(layer.finding);
      if (ofIt) ofIt.push(layer);
      else this.byFinding.set(layer.finding, [layer]);
    }
  }

  private readonly byFinding = new Map<number, Layer[]>();
  private readonly found = new Map<string, Record<string, Layer[]>>(); // of all findings, by role and kind

  /// The roles of what is drawn of findings, as they first come.
  get foundRoles(): string[] {
    return [...this.found.keys()];
  }

  /// What is drawn of all findings in that role, of that kind.
  foundOf(role: string, kind: string): Layer[] {
    return this.found.get(role)?.[kind] ?? [];
  }

  /// What is drawn while this finding is chosen.
  layersOf(finding: number | undefined): Layer[] {
    return (finding === undefined ? undefined : this.byFinding.get(finding)) ?? [];
  }

  static async read(): Promise<PageData> {
    const [header, report, bytes] = await Promise.all([jsonIn('toccata-header'), jsonIn('toccata-report'), inflated('toccata-data').arrayBuffer()]);
    const { format } = header as Header;
    if (format !== 'toccata/view/4') throw new Error(`this page cannot show ${format}`);
    const { objects } = report as Report;
    return new PageData(header as Header, { ...(report as Report), objects: objects.map((object) => ({ ...plainObject, ...object })) }, bytes);
  }

  floats(place: ArrayPlace): Float32Array {
    return new Float32Array(this.bytes, place.at, place.count);
  }

  integers(place: ArrayPlace): Uint32Array {
    return new Uint32Array(this.bytes, place.at, place.count);
  }

  shorts(place: ArrayPlace): Uint16Array {
    return new Uint16Array(this.bytes, place.at, place.count);
  }
}

/// What an element of the page holds, which is deflated and written in base64.
function inflated(id: string): Response {
  const text = document.getElementById(id)?.textContent;
  if (text === null || text === undefined) throw new Error('the page holds no data: it is the empty template');
  if (typeof DecompressionStream === 'undefined') throw new Error('the browser is too old: Chrome 80, Firefox 113 or Safari 16.4 are the first that can read it');
  return new Response(new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream('deflate')));
}

async function jsonIn(id: string): Promise<unknown> {
  return parsedVisibly(await inflated(id).text());
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const { fromBase64 } = Uint8Array as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> };
  if (fromBase64) return fromBase64.call(Uint8Array, base64);
  const characters = atob(base64);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}
