// Finding an icon to insert: those that fit first, and among them what was typed.
import type { OnikonView } from '../api.gen'
import { fits, type Gap } from '../onikon/fits'
import type { Entry } from '../onikon/choose'

export interface Found {
  readonly name: string
  readonly caption: string
  readonly type: string
  readonly doesFit: boolean
}

const MOST = 30

/** `entries` are all icons in the order of the dictionaries. What fills a hole comes before what only fits. */
export function find(
  words: string,
  entries: readonly Entry[],
  onikons: Readonly<Record<string, OnikonView>>,
  gap: Gap | undefined,
): Found[] {
  const wanted = words.trim().toLowerCase().split(/\s+/).filter(Boolean)
  const ranked = entries.flatMap((entry, order) => {
    if (!wanted.every((word) => entry.text.includes(word))) return []
    const doesFit = fits(entry, gap)
    const isMissing = doesFit && gap?.isHole === true && onikons[entry.name]?.right === gap.right
    return [{ entry, doesFit, rank: [Number(!doesFit), Number(!isMissing), nearness(entry, wanted), order] }]
  })
  ranked.sort((a, b) => compared(a.rank, b.rank))
  return ranked.slice(0, MOST).map(({ entry: { name, caption, type }, doesFit }) => ({ name, caption, type, doesFit }))
}

/** How many of all icons fit, whatever was typed. */
export const countFitting = (entries: readonly Entry[], gap: Gap | undefined): number =>
  entries.filter((entry) => fits(entry, gap)).length

/** Less is nearer to what was typed. */
function nearness({ name, caption }: Entry, [word]: readonly string[]): number {
  if (!word) return 0
  if (name.toLowerCase().startsWith(word) || caption.toLowerCase().startsWith(word)) return 0
  return caption.toLowerCase().includes(` ${word}`)
    ? 1
    : caption.toLowerCase().includes(word) || name.toLowerCase().includes(word)
      ? 2
      : 3
}

function compared(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((value, k) => value !== b[k])
  return at < 0 ? 0 : a[at]! - b[at]!
}
