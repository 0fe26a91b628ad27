// Numbers and sentences for people. The relation's words are the engine's; numbers are those of the report, shortened.
import type { Header, Pair, Question, Report, Vec } from './data';

export function numberText(x: number): string {
  if (x === 0) return '0';
  return String(Number(x.toPrecision(6)));
}

/// A unit that is a number of others is multiplied: "2 × 0.3 m". Null stands for lengths beyond the largest double.
export function lengthText(x: number | null, unit: string): string {
  if (x === null) return `more than ${lengthText(Number.MAX_VALUE, unit)}`;
  if (unit === 'unit') return numberText(x);
  return `${numberText(x)} ${/^[-+.\d]/.test(unit) ? '× ' : ''}${unit}`;
}

export function countText(n: number, one: string, many = `${one}s`): string {
  return `${n.toLocaleString('en-US')} ${n === 1 ? one : many}`;
}

export function vectorText(v: Vec): string {
  return `(${v.map((x) => numberText(x)).join(', ')})`;
}

/// Of length 1: six decimals tell it, and what is less is rounding.
export function directionText(v: Vec): string {
  return `(${v.map((x) => String(Number(x.toFixed(6)) + 0)).join(', ')})`;
}

/// How many faces meet, where at least one of the two is made of faces; other shapes are one element each.
function facesText(header: Header, report: Report, index: number): string {
  const pair = report.pairs[index];
  const count = header.words[index].face_pairs;
  const meshes = [pair.a_index, pair.b_index].filter((i) => report.objects[i].triangles > 0).length;
  if (count === undefined || meshes === 0) return '';
  if (count === 0) return pair.containment !== 'none' ? 'no faces meet' : '';
  return meshes === 2 ? countText(count, 'face pair') : countText(count, 'face');
}

/// The one number of a pair that people sort by: "0.5 m deep", "2 m apart", "24 face pairs".
export function pairNumber(header: Header, report: Report, index: number): string {
  const pair = report.pairs[index];
  if (pair.distance && pair.distance.upper !== 0) return `${lengthText(pair.distance.upper, report.unit)} apart`;
  if (pair.penetration && pair.penetration.upper !== 0) return `${lengthText(pair.penetration.upper, report.unit)} deep`;
  return facesText(header, report, index);
}

function depthText(pair: Pair, unit: string): string[] {
  const depth = pair.penetration;
  if (!depth || depth.upper === 0) return [];
  const [lower, upper] = [depth.lower, depth.upper].map((x) => lengthText(x, unit));
  const range = lower === upper || depth.lower === null || depth.upper === null ? '' : `${numberText(depth.lower)} to `;
  const way = `moving B by it along ${directionText(depth.direction)} parts them`;
  return [`${range}${upper} deep; ${way}`];
}

function distanceText(pair: Pair, unit: string): string[] {
  const { distance } = pair;
  if (!distance || distance.upper === 0) return [];
  return [`${lengthText(distance.upper, unit)} apart, from ${vectorText(distance.on_a)} to ${vectorText(distance.on_b)}`];
}

/// How it was found out, by the engine's table of pairs.
function methodTexts(header: Header, index: number, pair: Pair): string[] {
  const methods = (question: Question) => header.methods[header.words[index].methods[question] ?? -1];
  const decided = pair.status === 'exact' ? 'decided exactly' : `status: ${pair.status.replace('_', ' ')}`;
  const texts = [methods('relation') ? `${decided}, by ${methods('relation')}` : decided];
  if (methods('penetration') && pair.penetration?.upper !== 0) texts.push(`depth by ${methods('penetration')}`);
  if (methods('distance') && pair.distance?.upper !== 0) texts.push(`distance by ${methods('distance')}`);
  return texts;
}

/// What is known of a pair beside its sentence, a line each.
export function pairFacts(header: Header, report: Report, index: number): string[] {
  const pair = report.pairs[index];
  const facts: string[] = [];
  facts.push(...distanceText(pair, report.unit));
  facts.push(...depthText(pair, report.unit));
  const faces = facesText(header, report, index);
  if (faces) facts.push(faces.startsWith('no') ? faces : `${faces} in contact`);
  if (pair.regions && pair.regions.length > 0) facts.push(countText(pair.regions.length, 'region of contact', 'regions of contact'));
  if (pair.manifold) facts.push(countText(pair.manifold.points.length, 'point of contact', 'points of contact'));
  facts.push(...methodTexts(header, index, pair));
  return facts;
}

export type Order = 'deepest' | 'largest' | 'nearest' | 'listed';

const depthOf = (pair: Pair) => (pair.penetration ? (pair.penetration.upper ?? Infinity) : 0);
const gapOf = (pair: Pair) => (pair.relation === 'apart' ? (pair.distance?.upper ?? Infinity) : 0);

/// The numbers of the pairs in that order; those that are equal in it stay as listed.
export function sortedPairs(header: Header, report: Report, order: Order): number[] {
  const pairs = report.pairs;
  const faces = (i: number) => header.words[i].face_pairs ?? 0;
  const numbers = pairs.map((_, i) => i);
  if (order === 'deepest')
    numbers.sort((i, j) => compare(depthOf(pairs[j]), depthOf(pairs[i])) || compare(gapOf(pairs[i]), gapOf(pairs[j])) || faces(j) - faces(i) || i - j);
  if (order === 'largest') numbers.sort((i, j) => faces(j) - faces(i) || i - j);
  if (order === 'nearest') numbers.sort((i, j) => compare(gapOf(pairs[i]), gapOf(pairs[j])) || i - j);
  return numbers;
}

const compare = (a: number, b: number) => (a < b ? -1 : a > b ? 1 : 0);
