// What the page lists: a finding for each entry of the report, whatever was asked. Every sentence is put together here,
// of the engine's words and numbers; nothing is computed but how a number is written.
import type { Distance, GonePair, Header, Pair, PageData, Penetration, Region, Report, Vec, WorldPair } from './data';
import { ofInspected } from './inspected';
import { ofParts, ofSubdivided, ofSum } from './made';
import { ofCosts, ofTrees } from './measured';
import { boundTexts, bracketText, countText, directionText, groupedText, lengthText, lowerBoundText, numberText, upperBoundText, vectorText, withUnit } from './words';

/// A text, or the name of an object, which is untrusted.
export type Part = string | { object: number };

export interface Finding {
  row: Part[]; // what it is called in the list
  what: string; // and what was found, in few words
  sentence: Part[];
  facts: Part[][];
  a?: number; // the objects that are meant, in two colours
  b?: number;
  outer?: number; // the one that contains the other
  counts: boolean; // as a contact, a hit: whose objects are coloured while none is chosen
  depth: number; // what is sorted by
  gap: number;
  size: number;
  poses?: [number[], number[]]; // where A and B are in it
  moment?: number; // at which it is there, and listed
  place?: [Vec, Vec]; // in the world: what is looked at when it is chosen
  regions?: [Vec, Vec][]; // boxes around the places of which it consists
  kind?: string; // by which it is grouped
  since?: string; // the baseline
  subdued?: boolean; // no clash any more, or none by the tolerance
}

export type Order = 'deepest' | 'largest' | 'nearest' | 'listed';

export interface Findings {
  all: Finding[];
  name: string; // of the list
  summary: string[];
  none: string; // where there is nothing in it
  orders: Order[]; // the first is taken where nothing is chosen
  shown: string[]; // roles of layers that are drawn while none is chosen
  distinct?: boolean; // every object that is listed has a colour while none is chosen, not those of contacts alone
}

const plain = { counts: false, depth: 0, gap: 0, size: 0 };

/// How it was found out, by the engine's table of pairs.
class Methods {
  constructor(private readonly header: Header) {}

  facts(index: number, status: string | undefined, depth?: Penetration | null, distance?: Distance): Part[][] {
    const methods = this.header.words[index]?.methods ?? {};
    const text = (question: keyof typeof methods) => this.header.methods[methods[question] ?? -1];
    const facts: string[] = [];
    const by = text('relation') ?? text('cast');
    if (status !== undefined) facts.push(decided(status) + (by ? `, by ${by}` : ''));
    if (text('penetration') && depth?.upper !== 0) facts.push(`depth by ${text('penetration')}`);
    if (text('distance') && distance?.upper !== 0) facts.push(`distance by ${text('distance')}`);
    return facts.map((fact) => [fact]);
  }
}

const decided = (status: string) => (status === 'exact' ? 'decided exactly' : `status: ${status.replace('_', ' ')}`);

const depthText = ({ lower, upper }: { lower: number | null; upper: number | null }, unit: string) => `${bracketText(lower, upper, unit)} deep`;

/// How deep, and which of the two moved how far parts them.
function depthFacts(depth: Penetration | null | undefined, moved: number, unit: string): Part[][] {
  if (!depth || depth.upper === 0) return [];
  const [first, last] = depth.lower === null || depth.upper === null ? [] : boundTexts(depth.lower, depth.upper);
  const far = first === undefined ? 'far enough' : last === undefined ? 'by it' : `by ${withUnit(last, unit)}`;
  return [[`${depthText(depth, unit)}; moving `, { object: moved }, ` ${far} along ${directionText(depth.direction)} parts them`]];
}

function distanceFacts(distance: Distance | undefined, unit: string): Part[][] {
  if (!distance || distance.upper === 0) return [];
  return [[`${lengthText(distance.upper, unit)} apart, from ${vectorText(distance.on_a)} to ${vectorText(distance.on_b)}`]];
}

const depthOf = (depth: Penetration | null | undefined) => (depth ? (depth.upper ?? Infinity) : 0);
const gapOf = (distance: Distance | undefined) => (distance ? (distance.upper ?? Infinity) : 0);

function numberOf(unit: string, distance: Distance | undefined, depth: Penetration | null | undefined): string {
  if (distance && distance.upper !== 0) return `${lengthText(distance.upper, unit)} apart`;
  return depth && depth.upper !== 0 ? depthText(depth, unit) : '';
}

const together = (...words: string[]) => words.filter((word) => word !== '').join(' · ');

/// How deep and large the first few places are.
function regionFacts(regions: Region[], unit: string): Part[][] {
  const few = 3;
  const facts = regions.slice(0, few).map((region, i): Part[] => {
    const deep = region.depth_upper ? `, ${depthText({ lower: region.depth, upper: region.depth_upper }, unit)}` : '';
    return [`place ${i + 1} of ${regions.length}: area ${numberText(region.area)}${deep}`];
  });
  return regions.length > few ? [...facts, [`and ${countText(regions.length - few, 'more place')}`]] : facts;
}

function volumeFacts({ volume, point }: Pair, unit: string): Part[][] {
  if (!volume) return [];
  const cubed = unit === 'unit' ? '' : ` ${unit}³`;
  const amount = volume.status === 'exact' ? numberText(volume.upper) : bracketText(volume.lower, volume.upper, 'unit');
  return [[`volume in common ${amount}${cubed}`], ...(point ? [[`around ${vectorText(point)}`]] : [])];
}

const toleranceWords = { within: 'within the tolerance', beyond: 'beyond the tolerance', undecided: 'undecided whether within the tolerance' };

/// As the field calls it.
function kindOf(pair: Pair): string {
  if (pair.tolerance === 'within') return 'within tolerance';
  if (pair.relation === 'apart' && pair.clearance === 'all') return 'apart';
  if (pair.kind) return pair.kind;
  if (pair.relation === 'apart') return 'clearance';
  if (pair.relation === 'touching') return 'touching';
  return pair.containment === 'none' ? 'hard' : pair.containment === 'equal' ? 'equal' : 'contains';
}

const piercingVerbs = { a_through_b: 'pierces', b_through_a: 'is pierced by', unknown: 'pierces or is pierced by' };

const verbOf = ({ kind, piercing }: Pair, plainVerb: string) =>
  kind === 'pierce' ? piercingVerbs[piercing ?? 'unknown'] : kind === 'protrude' ? 'protrudes into' : plainVerb;

/// How it stands to the tolerance, and by which depth where that is one of a place.
function toleranceFact({ tolerance, local_depth: depth }: Pair, unit: string): Part[][] {
  if (!tolerance) return [];
  if (!depth) return [[toleranceWords[tolerance]]];
  const isWithin = tolerance === 'within' && depth.upper !== null;
  const by = isWithin ? `nowhere more than ${upperBoundText(depth.upper!, unit)} deep` : `${lowerBoundText(depth.lower, unit)} deep or more in one place`;
  return [[`${toleranceWords[tolerance]}: ${by}`]];
}

const reasons: Record<string, string> = {
  apart: 'no clash now',
  touching: 'now merely touching, ignored as asked',
  left_out: 'not checked now',
  no_object: 'not in the files now',
};

/// A clash of the baseline that is gone.
function ofGone(pair: GonePair, report: Report): Finding {
  const object = (name: string): Part => {
    const found = report.objects.findIndex((one) => one.name === name);
    return found < 0 ? name : { object: found };
  };
  const [a, b] = [object(pair.a), object(pair.b)];
  const index = (part: Part) => (typeof part === 'string' ? undefined : part.object);
  const why = reasons[pair.reason] ?? pair.reason;
  return {
    row: [a, ' – ', b], what: `gone · ${why}`, sentence: [a, ' and ', b, `: gone since the baseline, ${why}.`], facts: [],
    a: index(a), b: index(b), ...plain, gap: Infinity, depth: -1, kind: 'gone', since: 'gone', subdued: true,
  };
}

/// How it stands against the baseline.
const sinceOf = ({ baseline, moved_by }: Pair, unit: string): string =>
  baseline === 'moved' && moved_by ? `moved by ${lengthText(moved_by, unit)}` : (baseline ?? '');

/// What it was, where that was something else or less.
function beforeOf({ was, relation }: Pair, unit: string): string {
  if (!was) return '';
  const depth = was.penetration ?? was.local_depth;
  if (was.relation !== relation || !(depth ?? was.volume)) return `, ${was.relation} before`;
  if (depth) return `, ${bracketText(depth.lower, depth.upper, unit)} deep before`;
  const cubed = unit === 'unit' ? '' : ` ${unit}³`;
  return was.volume ? `, ${bracketText(was.volume.lower, was.volume.upper, 'unit')}${cubed} in common before` : '';
}

/// What stands below the sentence.
function pairFacts(pair: Pair, faces: string, unit: string): Part[][] {
  const facts = [...distanceFacts(pair.distance, unit), ...depthFacts(pair.penetration, pair.b_index, unit)];
  if (faces) facts.push([faces.startsWith('no') ? faces : `${faces} in contact`]);
  facts.push(...volumeFacts(pair, unit));
  facts.push(...toleranceFact(pair, unit));
  if (pair.baseline) facts.push([`since the baseline: ${sinceOf(pair, unit)}${beforeOf(pair, unit)}`]);
  if (pair.regions?.length) facts.push([countText(pair.regions.length, 'region of contact', 'regions of contact')], ...regionFacts(pair.regions, unit));
  if (pair.manifold) facts.push([countText(pair.manifold.points.length, 'point of contact', 'points of contact')]);
  return facts;
}

/// `check`.
function ofPairs({ header, report }: PageData): Findings {
  const methods = new Methods(header);
  const pairs = report.pairs ?? [];
  const all = pairs.map((pair, i): Finding => {
    const { verb: plainVerb = '', remark = '', place } = header.words[i];
    const verb = verbOf(pair, plainVerb);
    const [a, b] = [pair.a_index, pair.b_index];
    const near = pair.relation === 'apart';
    return { // of ten thousand, texts are put together of those that are seen
      get row() {
        return [{ object: a }, ' – ', { object: b }];
      },
      get what() {
        const number = numberOf(report.unit, pair.distance, pair.penetration) || facesText(header, report, pair, i);
        return together(pair.baseline && pair.baseline !== 'known' ? pair.baseline : '', number ? together(near ? 'near' : verb, number) : verb, pair.tolerance === 'within' ? 'within tolerance' : '');
      },
      get sentence() {
        return [{ object: a }, ` ${verb} `, { object: b }, ` ${remark}.`];
      },
      get facts() {
        return [...pairFacts(pair, facesText(header, report, pair, i), report.unit), ...methods.facts(i, pair.status, pair.penetration, pair.distance)];
      },
      get regions() {
        return boxesOf(pair.regions);
      },
      a, b, outer: outerOf(pair.containment, a, b), counts: !near && pair.tolerance !== 'within',
      place, kind: kindOf(pair), since: pair.baseline, subdued: pair.tolerance === 'within',
      depth: depthOf(pair.penetration), gap: near ? (pair.distance?.upper ?? Infinity) : 0, size: header.words[i].face_pairs ?? 0,
    };
  });
  if (report.objects.length < 2) return ofNoQuestion({ header, report });
  const within = pairs.filter((pair) => pair.tolerance === 'within').length;
  const near = all.filter((finding) => !finding.counts).length - within;
  const contacts = `Contacts ${counted(all.length - near - within)}`;
  const gone = (report.baseline?.gone ?? []).map((pair) => ofGone(pair, report));
  return {
    all: [...all, ...gone],
    name: near > 0 ? `${contacts} · near ${counted(near)}` : contacts,
    summary: [
      `${countText(all.length - near - within, 'pair')} in contact`,
      ...(near > 0 ? [`${countText(near, 'pair')} near`] : []),
      ...(within > 0 ? [`${counted(within)} within tolerance`] : []),
      ...(report.baseline ? [sinceText(pairs, gone.length)] : []),
    ],
    none: 'Nothing collides.', orders: ['deepest', 'largest', 'nearest', 'listed'], shown: ['contact'],
  };
}

const boxesOf = (regions: Region[] | undefined) =>
  regions?.flatMap(({ lower, upper }): [Vec, Vec][] => (lower && upper ? [[lower, upper]] : []));

function sinceText(pairs: Pair[], gone: number): string {
  const count = (since: string) => pairs.filter((pair) => pair.baseline === since).length;
  return `since the baseline ${count('new')} new, ${count('graver')} graver, ${count('moved')} moved, ${count('known')} known, ${gone} gone`;
}

/// Where there is nothing that could collide, the page is about what can be looked at.
function ofNoQuestion({ header, report }: Pick<PageData, 'header' | 'report'>): Findings {
  const shown = header.layers.flatMap(({ name, steps }) => (name !== undefined && steps && steps.length > 0 ? [{ name, steps: steps.length }] : []));
  const told = shown.map(({ name, steps }) => `${name}: ${countText(steps, 'step')}, on the slider in the picture.`).join(' ');
  const alone = report.objects.length === 0 ? 'There is no object.' : 'One object alone: there is no other that it could collide with.';
  return { all: [], name: 'Shown', summary: shown.map(({ name }) => name), none: told || alone, orders: ['listed'], shown: [] };
}

const counted = groupedText;

function outerOf(containment: string, a: number, b: number): number | undefined {
  return containment === 'a_in_b' ? b : containment === 'b_in_a' ? a : undefined;
}

/// How many faces meet, where at least one of the two is made of faces; other shapes are one element each.
function facesText(header: Header, report: Report, pair: Pair, index: number): string {
  const count = header.words[index].face_pairs ?? undefined;
  const meshes = [pair.a_index, pair.b_index].filter((i) => report.objects[i].triangles > 0).length;
  if (count === undefined || meshes === 0) return '';
  if (count === 0) return pair.containment !== 'none' ? 'no faces meet' : '';
  return meshes === 2 ? countText(count, 'face pair') : countText(count, 'face');
}

/// `distance`.
function ofDistances({ header, report }: PageData): Findings {
  const methods = new Methods(header);
  const all = (report.pairs as unknown as (Distance & { a_index: number; b_index: number })[]).map((pair, i): Finding => {
    const [a, b] = [pair.a_index, pair.b_index];
    const meets = pair.upper === 0;
    return {
      row: [{ object: a }, ' – ', { object: b }],
      what: meets ? 'meet' : numberOf(report.unit, pair, null),
      sentence: [{ object: a }, ' and ', { object: b }, meets ? ' meet.' : ` are ${lengthText(pair.upper, report.unit)} apart.`],
      facts: [...distanceFacts(pair, report.unit), ...facesOf(report, pair, a, b), [statusOf(pair.status)], ...methods.facts(i, undefined, null, pair)],
      a, b, ...plain, counts: meets, gap: gapOf(pair),
    };
  });
  const meeting = all.filter((finding) => finding.counts).length;
  return {
    all, name: `Distances ${counted(all.length)}`, summary: [countText(all.length, 'distance'), ...(meeting > 0 ? [`${countText(meeting, 'pair')} meeting`] : [])],
    none: 'There are no two objects.', orders: ['nearest', 'listed'], shown: ['distance'],
  };
}

const statusOf = (status: string) => (status === 'exact' ? 'certified' : decided(status));

/// The faces that the nearest points are on, where the objects have some.
function facesOf(report: Report, distance: Distance, a: number, b: number): Part[][] {
  if (distance.upper === 0) return [];
  const of = (object: number, face: number): Part[][] =>
    report.objects[object].triangles > 0 ? [[`face ${face} of `, { object }]] : [];
  return [...of(a, distance.face_a), ...of(b, distance.face_b)];
}

/// `check --poses`, `distance --poses`: the first object is A, the second B, at many poses.
function ofPoses(data: PageData): Findings {
  const isDistance = data.report.schema.includes('distance');
  const queries = data.report.queries ?? [];
  const methods = new Methods(data.header);
  const { unit } = data.report;
  const meshes = data.report.objects.filter((object) => object.triangles > 0).length;
  const all = queries.map((query, i): Finding => {
    const { verb = '', remark = '' } = data.header.words[i];
    const distance = isDistance ? (query as unknown as Distance) : undefined;
    const meets = isDistance ? distance?.upper === 0 : query.contact;
    const told = isDistance ? (meets ? 'meet' : numberOf(unit, distance, null)) : verb;
    const drawn = data.header.words[i].face_pairs;
    const count = query.face_pairs ?? drawn ?? 0;
    const faces = count > 0 && meshes === 2 ? countText(count, 'face pair') : '';
    const facts = [...distanceFacts(distance, unit), ...depthFacts(query.penetration, 1, unit)];
    if (faces) facts.push([`${faces} in contact`]);
    if (drawn === null && meets) facts.push(['the faces that meet are drawn at earlier poses alone']);
    if (query.regions?.length) facts.push([countText(query.regions.length, 'region of contact', 'regions of contact')]);
    if (distance) facts.push(...facesOf(data.report, distance, 0, 1), [statusOf(query.status)]);
    const between = isDistance ? (meets ? ' meets ' : ` is ${lengthText(distance?.upper ?? null, unit)} from `) : ` ${verb} `;
    return {
      row: [`Pose ${i}`],
      what: together(told, numberOf(unit, undefined, query.penetration) || faces),
      sentence: [`At pose ${i} `, { object: 0 }, between, { object: 1 }, remark ? ` ${remark}.` : '.'],
      facts: [...facts, ...methods.facts(i, isDistance ? undefined : query.status, query.penetration, distance)],
      a: 0, b: 1, outer: outerOf(query.containment ?? 'none', 0, 1), counts: meets === true,
      depth: depthOf(query.penetration), gap: gapOf(distance), size: count, poses: [query.pose_a, query.pose_b],
    };
  });
  const meeting = all.filter((finding) => finding.counts).length;
  return {
    all, name: `Poses ${counted(all.length)}`, summary: [`${counted(meeting)} of ${countText(all.length, 'pose')} in contact`],
    none: 'No pose was asked about.', orders: isDistance ? ['listed', 'nearest'] : ['listed', 'deepest', 'largest'], shown: [],
  };
}

/// `check --self`.
function ofSelf({ report }: PageData): Findings {
  const all = (report.self_contacts ?? []).map((one): Finding => {
    const meets = one.face_pairs > 0;
    const object = one.object_index;
    return {
      row: [{ object }],
      what: meets ? together('self-intersects', countText(one.face_pairs, 'face pair')) : 'does not intersect itself',
      sentence: [{ object }, meets ? ' intersects itself.' : ' does not intersect itself.'],
      facts: [...(meets ? [[`${countText(one.face_pairs, 'face pair')} in contact`], [countText(one.triangle_pairs, 'pair of triangles', 'pairs of triangles')]] : []), ['decided exactly']],
      a: object, ...plain, counts: meets, size: one.face_pairs,
    };
  });
  const meeting = all.filter((finding) => finding.counts).length;
  return {
    all, name: `Self-contacts ${counted(meeting)}`, summary: [`${countText(meeting, 'object')} in contact with ${meeting === 1 ? 'itself' : 'themselves'}`],
    none: 'There is no object.', orders: ['largest', 'listed'], shown: ['contact'],
  };
}

/// `ray`.
function ofRays({ header, report }: PageData): Findings {
  const methods = new Methods(header);
  const all = (report.rays ?? []).map((ray, i): Finding => {
    const from = [`from ${vectorText(ray.from)} along ${vectorText(ray.motion)}`];
    if (ray.object_index === undefined)
      return { row: [`Ray ${i}`], what: 'meets nothing', sentence: [`Ray ${i} meets nothing.`], facts: [from, [decided(ray.status)]], ...plain, gap: Infinity };
    const object = ray.object_index;
    const way = `after ${numberText(ray.upper ?? 0)} of its way`;
    const length = (ray.upper ?? 0) * Math.hypot(...ray.motion);
    const facts: Part[][] = [[`${lengthText(length, report.unit)} from its start`], [`at ${vectorText(ray.point!)}`], [`normal ${directionText(ray.normal!)}`], from];
    if (report.objects[object].triangles > 0) facts.push([`face ${ray.face}`]);
    return {
      row: [`Ray ${i} – `, { object }], what: `meets it ${way}`, sentence: [`Ray ${i} meets `, { object }, ` ${way}.`],
      facts: [...facts, ...methods.facts(i, ray.status)],
      a: object, ...plain, counts: true, gap: length,
    };
  });
  const met = all.filter((finding) => finding.counts).length;
  return {
    all, name: `Rays ${counted(all.length)}`, summary: [`${counted(met)} of ${countText(all.length, 'ray')} met something`],
    none: 'No ray was asked about.', orders: ['listed', 'nearest'], shown: ['ray', 'hit'],
  };
}

/// `faces`: a finding for each object of which faces were found.
function ofFaces({ header, report }: PageData): Findings {
  const { region } = report;
  const where = region?.radius !== undefined ? `the ball of radius ${lengthText(region.radius, report.unit)} around ${vectorText(region.centre!)}`
    : region ? `the box from ${vectorText(region.lower!)} to ${vectorText(region.upper!)}` : '';
  const all = header.words.map((word): Finding => {
    const object = word.object ?? 0;
    const faces = word.faces ?? 0;
    return {
      row: [{ object }], what: countText(faces, 'face'),
      sentence: [`${countText(faces, 'face')} of `, { object }, ` ${faces === 1 ? 'has' : 'have'} a point in ${where}.`],
      facts: [[`${counted(faces)} of ${countText(report.objects[object].faces || 1, 'face')}`], [countText(word.triangles ?? 0, 'triangle')], ['decided exactly, touching included']],
      a: object, ...plain, counts: true, size: faces,
    };
  });
  const total = all.reduce((sum, finding) => sum + finding.size, 0);
  return {
    all, name: `Faces ${counted(total)}`, summary: [`${countText(total, 'face')} in ${where}`],
    none: `Nothing is in ${where}.`, orders: ['largest', 'listed'], shown: ['within'],
  };
}

/// "inside it", by the words of the report.
const sideText = (side: string | undefined) => (side === undefined ? '' : side === 'boundary' ? 'on it' : side === 'undecided' ? 'its side undecided' : `${side} it`);

/// `nearest`.
function ofPoints({ report }: PageData): Findings {
  const { unit } = report;
  const all = (report.points ?? []).map((point, i): Finding => {
    const [first] = point.nearest;
    const at: Part[] = [`Point ${i} at ${vectorText(point.point)}`];
    if (!first)
      return { row: [`Point ${i}`], what: 'nothing is so near', sentence: [...at, ' has nothing within the greatest distance.'], facts: [], ...plain, gap: Infinity };
    const facts = point.nearest.map((one): Part[] => {
      const face = report.objects[one.object_index].triangles > 0 ? `face ${one.face}, ` : '';
      const place = `${face}at ${vectorText(one.at)}`;
      if (point.nearest.length === 1) return [place];
      return [`${lengthText(one.upper, unit)} from `, { object: one.object_index }, `, ${place}`];
    });
    if (first.signed_upper !== undefined) facts.unshift([`signed distance ${lengthText(first.signed_upper, unit)}`]);
    if (point.inside_of !== undefined) facts.push(insideOf(report, point.inside_of));
    if (first.side_by) facts.push([`side by the ${first.side_by}`]);
    const side = sideText(first.side);
    return {
      row: [`Point ${i} – `, { object: first.object_index }],
      what: together(`${lengthText(first.upper, unit)} away`, side.replace(/ it$/, '')),
      sentence: [...at, ` is ${lengthText(first.upper, unit)} from `, { object: first.object_index }, side ? `, ${side}.` : '.'],
      facts: [...facts, [statusOf(first.status)]],
      a: first.object_index, ...plain, counts: true, gap: first.upper ?? Infinity,
    };
  });
  return {
    all, name: `Points ${counted(all.length)}`, summary: [countText(all.length, 'point')],
    none: 'No point was asked about.', orders: ['listed', 'nearest'], shown: ['distance', 'asked'],
  };
}

function insideOf(report: Report, name: string | null): Part[] {
  if (name === null) return ['inside of no object'];
  const object = report.objects.findIndex((one) => one.name === name);
  return object < 0 ? [`inside of ${name}`] : ['inside of ', { object }];
}

const kinds: Record<string, (data: PageData) => Findings> = {
  'toccata/world/2': ofWorld,
  'toccata/check/2': ofPairs,
  'toccata/check-poses/2': ofPoses,
  'toccata/check-self/2': ofSelf,
  'toccata/distance/1': ofDistances,
  'toccata/distance-poses/2': ofPoses,
  'toccata/ray/1': ofRays,
  'toccata/faces/1': ofFaces,
  'toccata/nearest/1': ofPoints,
  'toccata/inspect/1': ofInspected,
  'toccata/cost/1': ofCosts,
  'toccata/hierarchy/1': ofTrees,
  'toccata/decompose/1': ofParts,
  'toccata/minkowski/1': ofSum,
  'toccata/subdivide/1': ofSubdivided,
};

/// The pairs of a World, step by step.
function ofWorld({ report }: PageData): Findings {
  const steps = report.steps ?? [];
  const all = steps.flatMap(({ pairs }, moment) => pairs.map((pair) => ofWorldPair(pair, moment, report.unit)));
  return { all, name: 'Pairs', summary: [], none: 'At this step no bodies are in contact.', orders: ['listed', 'deepest', 'nearest'], shown: [] };
}

function ofWorldPair(pair: WorldPair, moment: number, unit: string): Finding {
  const [a, b] = [pair.a_index, pair.b_index];
  const isEnded = pair.change === 'end';
  const verb = pair.in_contact ? (pair.verb ?? 'is in contact with') : 'is closer than its clearance to';
  const since = { begin: 'since this step', persist: 'as at the step before', end: 'at the step before, and no longer' }[pair.change];
  const facts = isEnded ? [] : [...distanceFacts(pair.distance, unit), ...depthFacts(pair.penetration, b, unit)];
  if (!isEnded && pair.points) facts.push([countText(pair.points, 'point of contact', 'points of contact')]);
  return {
    row: [{ object: a }, ' – ', { object: b }],
    what: together(pair.change, isEnded ? '' : numberOf(unit, pair.distance, pair.penetration)),
    sentence: [{ object: a }, ` ${verb} `, { object: b }, `${pair.remark && pair.in_contact ? ` ${pair.remark}` : ''}: ${since}.`],
    facts, a, b, ...plain, depth: isEnded ? 0 : depthOf(pair.penetration), gap: isEnded ? Infinity : gapOf(pair.distance), moment,
  };
}

export function findingsOf(data: PageData): Findings {
  const kind = kinds[data.report.schema];
  if (!kind) throw new Error(`this page cannot show ${data.report.schema}`);
  return kind(data);
}

/// By what they are sorted, the least first.
const deepest = (finding: Finding) => -finding.depth, nearest = (finding: Finding) => finding.gap, largest = (finding: Finding) => -finding.size;
const keysOf: Record<Order, ((finding: Finding) => number)[]> = { deepest: [deepest, nearest, largest], nearest: [nearest], largest: [largest], listed: [] };

/// The numbers of the findings in that order; those that are equal in it stay as listed.
export function sorted(findings: Finding[], order: Order, moment: number): number[] {
  const keys = keysOf[order].map((key) => Float64Array.from(findings, key));
  const listed: number[] = [];
  findings.forEach((finding, i) => {
    if (finding.moment === undefined || finding.moment === moment) listed.push(i);
  });
  return listed.sort((i, j) => {
    for (const key of keys) if (key[i] !== key[j]) return key[i] < key[j] ? -1 : 1;
    return i - j;
  });
}

/// The texts of some parts, names as they are.
export const textOf = (parts: Part[], name: (object: number) => string) => parts.map((part) => (typeof part === 'string' ? part : name(part.object))).join('');
