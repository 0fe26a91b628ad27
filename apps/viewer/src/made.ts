// What the page lists of questions whose answers are shapes: of `decompose` every convex part, of `minkowski` the sum,
// of `subdivide` the mesh, or how far the limit surface is from the other object.
// The shapes themselves are objects of the page.
import type { PageData, Report } from './data';
import type { Finding, Findings, Part } from './findings';
import { countText, lengthText, numberText, vectorText } from './words';

const plain = { counts: false, depth: 0, gap: 0 };
const facts = (texts: string[]): Part[][] => texts.map((text) => [text]);

/// `decompose`; the parts are the objects, in their order.
export function ofParts({ report }: PageData): Findings {
  const { unit } = report;
  const parts = report.parts ?? [];
  const all = parts.map((part, i): Finding => {
    const nowhere = part.concavity === 0;
    const far = nowhere ? 'lies within the solid' : `lies at most ${lengthText(part.concavity, unit)} outside the solid`;
    return {
      row: [{ object: i }], what: `volume ${numberText(part.volume)}`, sentence: [{ object: i }, ` ${far}.`],
      facts: facts([
        `volume ${numberText(part.volume)}`,
        ...(nowhere ? [] : [`some point of it is ${lengthText(part.concavity_found, unit)} from the solid, at least`]),
        `${countText(part.vertices.length, 'vertex', 'vertices')} and ${countText(part.faces.length, 'face')}`,
        `${countText(part.source_faces.length, 'face')} of the mesh in it`,
      ]),
      a: i, ...plain, size: part.volume,
    };
  });
  const more = `${numberText(report.hull_volume ?? 0)} in all around a solid of ${numberText(report.mesh_volume ?? 0)}`;
  return {
    all, name: `Convex parts ${parts.length.toLocaleString('en-US')}`, summary: [countText(parts.length, 'convex part'), more],
    none: 'There is no part.', orders: ['listed'], shown: [], distinct: true,
  };
}

const solids = ['a point', 'a segment', 'a flat polygon', 'a solid'];
const sides: Record<string, string> = { inside: 'lies inside', boundary: 'lies on the boundary', outside: 'lies outside' };

function facesOfSum(report: Report): string[] {
  const kinds = (report.faces ?? []).map((face) => face.kind);
  return [...new Set(kinds)].map((kind) => `${countText(kinds.filter((one) => one === kind).length, 'face')} ${kind.replace(/\b[ab]$/, (of) => of.toUpperCase())}`);
}

/// `minkowski`; A and B are the first two objects, and their sum is the third.
export function ofSum({ report }: PageData): Findings {
  const what = `${solids[report.dimension ?? 0]} of ${countText(report.vertices?.length ?? 0, 'vertex', 'vertices')}`;
  const by = report.operation === 'difference' ? ' − ' : ' + ';
  const { point } = report;
  const sum: Finding = {
    row: [{ object: 0 }, by, { object: 1 }], what, sentence: [{ object: 0 }, by, { object: 1 }, ` is ${what}.`],
    facts: facts([
      ...facesOfSum(report),
      ...(report.radius ? [`grown by ${lengthText(report.radius, report.unit)}`] : []),
      ...(point ? [`${vectorText(point.position)} ${sides[point.side]}`] : []),
      'decided exactly',
    ]),
    a: 2, ...plain, size: 0,
  };
  return { all: [sum], name: 'Sum', summary: [what], none: 'There is no sum.', orders: ['listed'], shown: [] };
}

const proof = (status: string | undefined) => (status === 'exact' ? 'proved' : 'proved; less near than asked, as more triangles or faces were not allowed');

function ofLimitMesh({ unit, cage, triangles, distance_to_limit: near = 0, deepest_level: level = 0, status }: Report): Finding {
  const what = countText(triangles?.length ?? 0, 'triangle');
  return {
    row: [{ object: 0 }], what, sentence: [{ object: 0 }, ` is nowhere farther than ${lengthText(near, unit)} from the limit surface.`],
    facts: facts([`${what}, the smallest refined ${countText(level, 'time')}`, `of ${cage?.closed ? 'a closed' : 'an open'} cage of ${countText(cage?.faces ?? 0, 'face')}`, proof(status)]),
    a: 0, ...plain, size: 0,
  };
}

function ofLimitGap({ unit }: Report, gap: NonNullable<Report['gap']>): Finding {
  const meets = gap.upper === 0;
  const far = meets ? 'meet' : `from ${numberText(gap.lower)} to ${lengthText(gap.upper, unit)} apart`;
  return {
    row: [{ object: 0 }, ' – ', { object: 1 }], what: far,
    sentence: ['The limit surface of ', { object: 0 }, ' and ', { object: 1 }, meets ? ' meet.' : ` are ${far}.`],
    facts: facts([...(meets ? [] : [`from ${vectorText(gap.on_mesh)} to ${vectorText(gap.on_other)}`]), `refined ${countText(gap.level, 'time')} there`, proof(gap.status)]),
    a: 0, b: 1, ...plain, counts: meets, gap: gap.upper, size: 0,
  };
}

/// `subdivide`; of one cage the mesh is the object, else the cage and the other are.
export function ofSubdivided({ report }: PageData): Findings {
  const found = report.gap ? ofLimitGap(report, report.gap) : ofLimitMesh(report);
  return { all: [found], name: report.gap ? 'Distance' : 'Mesh', summary: [found.what], none: 'There is no mesh.', orders: ['listed'], shown: [] };
}
