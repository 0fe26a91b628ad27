// What the page lists of questions that measure: of `cost` every hierarchy, cheapest first; of `inspect --hierarchy` the
// tree of nodes as it is and what it could be.
import type { CostRow, PageData, TreeReport } from './data';
import type { Finding, Findings, Part } from './findings';
import { countText, numberText } from './words';

const plain = { counts: false, depth: 0, gap: 0, size: 0 };
const facts = (texts: string[]): Part[][] => texts.map((text) => [text]);

function timeText(nanoseconds: number): string {
  const units: [number, string][] = [[1e9, 's'], [1e6, 'ms'], [1e3, 'µs']];
  const unit = units.find(([size]) => nanoseconds >= size);
  return unit ? `${Number((nanoseconds / unit[0]).toPrecision(3))} ${unit[1]}` : `${Number(nanoseconds.toPrecision(3))} ns`;
}

function ofRow(row: CostRow, task: string, winners: string[]): Finding {
  const each = (count: number) => numberText(count / row.queries);
  return {
    row: [`${row.workload}: ${row.volume}, ${row.arity} children, ${row.builder}`],
    what: `${timeText(row.F_ns)} a query`,
    sentence: [`With ${row.volume}, ${row.arity} children a node, built by ${row.builder}, a question for ${task} costs ${timeText(row.F_ns)} (${row.workload}).`],
    facts: facts([
      `${each(row.N_u)} volumes updated at ${timeText(row.C_u_ns)}`,
      `${each(row.N_bv)} pairs of volumes compared at ${timeText(row.C_bv_ns)}`,
      `${each(row.N_p)} pairs of triangles compared at ${timeText(row.C_p_ns)}`,
      `as it ran: ${timeText(row.measured_ns)}, mean of ${countText(row.queries, 'query', 'queries')}`,
      `${countText(row.nodes, 'node')}, ${numberText(row.bytes / 1e6)} MB, built in ${timeText(row.build_ns)}`,
      ...winners,
    ]),
    a: 0, b: 1, ...plain,
  };
}

/// `cost`; the first row of a workload says why it is the cheapest.
export function ofCosts({ report }: PageData): Findings {
  const rows = report.rows ?? [];
  const all = rows.map((row, i) => ofRow(row, report.task ?? '', rows[i - 1]?.workload === row.workload ? [] : (report.winners?.[row.workload] ?? [])));
  return {
    all, name: `Costs ${rows.length.toLocaleString('en-US')}`, summary: [countText(rows.length, 'hierarchy', 'hierarchies'), ...(report.left_out ?? [])],
    none: 'Nothing was measured.', orders: ['listed'], shown: [],
  };
}

function ofTree(name: string, tree: TreeReport, cheaper: number): Finding {
  const gain = cheaper === 1 ? '' : `, ${numberText(cheaper)} times less than as it is`;
  return {
    row: [`The tree of nodes ${name}`],
    what: `F ${numberText(tree.F)} · ${countText(tree.nodes, 'node')}`,
    sentence: [`The tree of nodes ${name} finds all pairs of overlapping boxes with F = ${numberText(tree.F)}${gain}.`],
    facts: facts([
      `${tree.N_bv.toLocaleString('en-US')} pairs of boxes compared, ${tree.N_p.toLocaleString('en-US')} pairs of objects left`,
      `${countText(tree.nodes, 'node')} over ${countText(tree.leaves, 'object')}, ${tree.depth} deep, ${numberText(tree.mean_depth)} in the mean`,
      `at most ${countText(tree.most_children, 'child', 'children')} of one node`,
      `${tree.overlapping_sibling_pairs.toLocaleString('en-US')} of ${countText(tree.sibling_pairs, 'pair')} of siblings overlap`,
    ]),
    ...plain,
  };
}

/// `inspect --hierarchy`, in the order of the layers of boxes.
export function ofTrees({ report }: PageData): Findings {
  const trees = { 'as it is': report.as_is!, cured: report.cured!, rebuilt: report.rebuilt! };
  const all = Object.entries(trees).map(([name, tree]) => ofTree(name, tree, tree.F > 0 ? report.as_is!.F / tree.F : 1));
  const kept = `${report.kept_nodes} of ${countText(report.named_nodes ?? 0, 'named node')} kept by the cure`;
  return { all, name: 'Trees 3', summary: [kept], none: 'There is no tree.', orders: ['listed'], shown: [] };
}
