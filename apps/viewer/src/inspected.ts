// What the page lists of `inspect`: each object in words, and then the places where its mesh is out of order.
import type { PageData, ReportObject, Words } from './data';
import type { Finding, Findings, Part } from './findings';
import { countText, numberText, vectorText } from './words';

/// What is out of order, one of it and many, and what that means.
const faultWords: Record<string, [string, string, string]> = {
  boundary_edges: ['open edge', 'open edges', 'used by one triangle alone'],
  non_manifold_edges: ['non-manifold edge', 'non-manifold edges', 'used by more than two triangles'],
  flipped_edges: ['flipped edge', 'flipped edges', 'used by two triangles in the same direction'],
  degenerate_triangles: ['degenerate triangle', 'degenerate triangles', 'without area; kept, and answered exactly'],
  duplicate_triangles: ['duplicate triangle', 'duplicate triangles', 'the same three vertices as an earlier one; kept'],
  unused_vertices: ['unused vertex', 'unused vertices', 'in no triangle; ignored'],
};

const faultKinds = Object.keys(faultWords) as (keyof ReportObject & keyof typeof faultWords)[];

const isMesh = (object: ReportObject) => object.unbalanced_edges !== undefined;

const countOf = (object: ReportObject, kind: string) => Number((object as unknown as Record<string, number>)[kind] ?? 0);

function stateOf(object: ReportObject): string {
  if (object.refusal) return object.refusal;
  if (!isMesh(object)) return `a ${object.shape}, taken as ${object.solid ? 'a solid' : 'a surface'}`;
  if (!object.closed) return `open: ${countText(object.unbalanced_edges!, 'unbalanced edge')}; taken as a surface`;
  return (object.signed_volume ?? 0) < 0 ? 'closed, and inside out: its normals point inward' : 'closed: may be a solid';
}

function factsOf(object: ReportObject, unit: string): Part[][] {
  const facts: string[] = [];
  if (isMesh(object)) {
    facts.push(object.faces === object.triangles ? countText(object.triangles, 'triangle') : `${countText(object.triangles, 'triangle')} of ${countText(object.faces, 'face')}`);
    facts.push(`${countText(object.vertices!, 'vertex', 'vertices')}, ${object.distinct_vertices!.toLocaleString('en-US')} distinct`, countText(object.components!, 'part'));
    if (object.closed) facts.push(`volume ${numberText(object.signed_volume!)} in file units cubed`);
    for (const kind of faultKinds) if (countOf(object, kind) > 0) facts.push(faultText(kind, countOf(object, kind)));
  }
  const box = object.world_box;
  if (box) facts.push(`in the world from ${vectorText(box.lower)} to ${vectorText(box.upper)}${unit === 'unit' ? '' : ` ${unit}`}`);
  return [...facts, ...volumesOf(object), ...partitionsOf(object)].map((fact) => [fact]);
}

/// How full each bounding volume is, and its smallest hierarchy.
function volumesOf(object: ReportObject): string[] {
  const least = new Map<string, { fill: number; bytes: number }>();
  for (const { volume, fill, bytes } of object.volumes ?? []) {
    const known = least.get(volume);
    if (!known || bytes < known.bytes) least.set(volume, { fill, bytes });
  }
  return [...least].map(([volume, { fill, bytes }]) => `${volume} around it: ${Math.round(100 * fill)} % filled by its hull; a hierarchy from ${numberText(bytes / 1e6)} MB`);
}

const partitionsOf = (object: ReportObject) =>
  (object.partitions ?? []).map((one) => `${one.partition}: ${countText(one.cells, 'cell')}, ${numberText(one.items_per_cell)} triangles each, ${numberText(one.copies_per_item)} copies of a triangle`);

const faultText = (kind: string, count: number) => countText(count, faultWords[kind][0], faultWords[kind][1]);

const plain = { counts: false, depth: 0, gap: 0, size: 0 };

function ofObject(object: number, one: ReportObject, unit: string): Finding {
  const state = stateOf(one);
  return { row: [{ object }], what: state.split(':')[0], sentence: [{ object }, ` is ${state}.`], facts: factsOf(one, unit), a: object, ...plain };
}

function ofFault({ object = 0, fault = '', count = 0, groups = 1 }: Words, all: number): Finding {
  const text = faultText(fault, count);
  const places = groups > 1 ? ` at ${groups.toLocaleString('en-US')} other places` : '';
  return {
    row: [{ object }], what: text + places, sentence: [{ object }, ` has ${text}${places}: ${faultWords[fault][2]}.`],
    facts: all > count ? [[`${faultText(fault, all)} in all`]] : [], a: object, ...plain, counts: true, size: count,
  };
}

export function ofInspected({ header, report }: PageData): Findings {
  const all = header.words.map((words) => {
    const object = report.objects[words.object ?? 0];
    return words.fault ? ofFault(words, countOf(object, words.fault)) : ofObject(words.object ?? 0, object, report.unit);
  });
  const faults = all.reduce((sum, finding) => sum + finding.size, 0);
  return {
    all, name: `Inspected ${report.objects.length.toLocaleString('en-US')}`, summary: [faults > 0 ? countText(faults, 'fault') : 'nothing is out of order'],
    none: 'There is no object.', orders: ['listed', 'largest'], shown: faultKinds,
  };
}
