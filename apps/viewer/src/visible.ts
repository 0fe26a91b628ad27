// Texts of files, made safe to stand beside others.

/// Characters that are not seen, and those that turn the writing of what follows round: both would let a name pass for
/// another, or garble the sentence that it stands in.
const unseen = /[\u0000-\u001f\u007f-\u009f\u061c\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff]/g;

/// Each of them as "\u202e"; for JSON.parse.
export function visible(_key: string, value: unknown): unknown {
  return typeof value === 'string' ? value.replace(unseen, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`) : value;
}

/// A text in which a name is kept apart from what is around it, where no element can do so.
export const isolated = (name: string) => `\u2068${name}\u2069`;
