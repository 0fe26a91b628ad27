// The list of clashes: which are listed, under which headings, and what is said of them.
import type { PageData, Report } from './data';
import { textOf, type Finding } from './findings';
import type { Review } from './review';

export type Grouping = 'none' | 'part' | 'kind' | 'since' | 'status' | 'asked';

export const groupings: Record<Grouping, string> = {
  none: 'no groups',
  part: 'by part',
  kind: 'by kind',
  since: 'by baseline',
  status: 'by status',
  asked: 'as asked',
};

export interface Listed {
  heading?: string;
  finding?: number;
}

const partsOf = ({ a, b }: Finding) => [a, b].filter((object): object is number => object !== undefined);

/// Which groupings tell something apart here.
export function offeredGroupings({ report }: PageData, findings: Finding[]): Grouping[] {
  if (!report.schema.startsWith('toccata/check/')) return [];
  const offered: Grouping[] = ['none', 'part', 'kind', 'status'];
  if (report.baseline) offered.push('since');
  if (report.groups) offered.push('asked');
  return findings.length > 1 ? offered : [];
}

export class ClashList {
  filter = '';
  grouping: Grouping = 'none';
  private readonly groupOf = new Map<number, string>(); // as asked, of each finding

  constructor(
    private readonly report: Report,
    private readonly findings: Finding[],
    private readonly review: Review,
  ) {
    if (report.groups) this.grouping = 'asked';
    report.groups?.forEach(({ part, pairs }, i) => {
      for (const pair of pairs) this.groupOf.set(pair, part ?? `Place ${i + 1}`);
    });
  }

  nameOf = (object: number) => this.report.objects[object].name;

  private remarkOf(finding: Finding) {
    const [a, b] = partsOf(finding);
    return a !== undefined && b !== undefined ? this.review.of(this.nameOf(a), this.nameOf(b)) : undefined;
  }

  /// Its words: names, kind, what was found, status and comment.
  private wordsOf(finding: Finding): string {
    const remark = this.remarkOf(finding);
    const words = [textOf(finding.row, this.nameOf), finding.what, finding.kind ?? '', finding.since ?? '', remark?.status ?? '', remark?.comment ?? ''];
    return words.join(' ').toLowerCase();
  }

  /// The part that most of them are of, then of those that are left that which most are of, …
  private byPart(order: number[]): Map<string, number[]> {
    const membersOf = new Map<number, number[]>();
    for (const i of order)
      for (const part of partsOf(this.findings[i])) {
        const members = membersOf.get(part);
        if (members) members.push(i);
        else membersOf.set(part, [i]);
      }
    const counts = new Map([...membersOf].map(([part, members]) => [part, members.length]));
    const left = new Set(order);
    const groups = new Map<string, number[]>();
    while (left.size > 0) {
      let [most, count] = [-1, 0];
      for (const [part, members] of counts) if (members > count || (members === count && part < most)) [most, count] = [part, members];
      if (count === 0) return groups.set('', [...left]);
      const members = membersOf.get(most)!.filter((i) => left.delete(i));
      for (const i of members) for (const part of partsOf(this.findings[i])) counts.set(part, counts.get(part)! - 1);
      groups.set(this.nameOf(most), members);
    }
    return groups;
  }

  private headingOf(i: number): string {
    const finding = this.findings[i];
    if (this.grouping === 'kind') return finding.kind ?? 'other';
    if (this.grouping === 'since') return finding.since ?? '';
    if (this.grouping === 'status') return this.remarkOf(finding)?.status ?? 'open';
    return this.groupOf.get(i) ?? 'gone';
  }

  /// In that order, those that hold all words of the filter, under headings where they are grouped.
  listed(order: number[]): Listed[] {
    const wanted = this.filter.toLowerCase().split(/\s+/).filter((word) => word !== '');
    const shown = wanted.length === 0 ? order : order.filter((i) => wanted.every((word) => this.wordsOf(this.findings[i]).includes(word)));
    if (this.grouping === 'none') return shown.map((finding) => ({ finding }));
    const groups = this.grouping === 'part' ? this.byPart(shown) : new Map<string, number[]>();
    if (this.grouping !== 'part')
      for (const i of shown) {
        const heading = this.headingOf(i);
        const members = groups.get(heading);
        if (members) members.push(i);
        else groups.set(heading, [i]);
      }
    return [...groups].flatMap(([heading, members]) => [{ heading: `${heading} · ${members.length}` }, ...members.map((finding) => ({ finding }))]);
  }
}
