// Texts of files, made safe to stand beside others.

/// Characters that are not seen, and those that turn the writing of what follows round: both would let a name pass for
/// another, or garble the sentence that it stands in.
const unseen = /[\u0000-\u001f\u007f-\u009f\u061c\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff]/;

const isUnseen = (c: string) => c.search(unseen) >= 0;

/// Of JSON texts: the escapes in it, and what is unseen without being one.
const escapes = new RegExp(`\\\\(?:u([0-9a-fA-F]{4})|[^u])|${unseen.source.replace('\\u0000-\\u001f', '')}`, 'g');
const shortEscapes: Record<string, string> = { '\\b': '\b', '\\f': '\f', '\\n': '\n', '\\r': '\r', '\\t': '\t' };

/// Of JSON texts without a backslash, which hold no control character below 0x20 but those between their values.
const unseenAsIs = new RegExp(unseen.source.replace('\\u0000-\\u001f', ''));

/// What a JSON text holds, with each of them as "\u202e". It is the text that is looked through: a report has a million numbers, and to be
/// asked about each takes seconds.
export function parsedVisibly(json: string): unknown {
  if (!json.includes('\\') && !unseenAsIs.test(json)) return JSON.parse(json);
  const shown = json.replace(escapes, (whole: string, code?: string) => {
    const c = code === undefined ? (shortEscapes[whole] ?? whole) : String.fromCharCode(parseInt(code, 16));
    return c.length === 1 && isUnseen(c) ? `\\\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}` : whole;
  });
  return JSON.parse(shown);
}

/// A text in which a name is kept apart from what is around it, where no element can do so.
export const isolated = (name: string) => `\u2068${name}\u2069`;
