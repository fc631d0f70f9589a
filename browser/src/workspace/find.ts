// Finding an icon to insert: those that fit first, and among them what was typed.
import type { OnikonView } from '../api.gen'
import { fits, isOfAnotherArm, type Gap } from '../onikon/fits'
import type { Entry } from '../onikon/choose'

export interface Found {
  readonly name: string
  readonly caption: string
  readonly type: string
  readonly doesFit: boolean
  /** In place of an icon: how many that were made for another arm are left out; who chooses it wants to see them. */
  readonly leftOut?: number
}

const MOST = 30

/**
 * `entries` are all icons in the order of the dictionaries. What fills a hole comes before what only fits. Targets of
 * other arms than those with these tasks are left out; the last line says how many.
 */
export function find(
  words: string,
  entries: readonly Entry[],
  onikons: Readonly<Record<string, OnikonView>>,
  gap: Gap | undefined,
  hardware: readonly string[] = [],
): Found[] {
  const wanted = words.trim().toLowerCase().split(/\s+/).filter(Boolean)
  const named = entries.filter((entry) => wanted.every((word) => entry.text.includes(word)))
  const offered = named.filter((entry) => !(fits(entry, gap) && isOfAnotherArm(entry, hardware)))
  const ranked = offered.map((entry, order) => {
    const doesFit = fits(entry, gap)
    const isMissing = doesFit && gap?.isHole === true && onikons[entry.name]?.right === gap.right
    return { entry, doesFit, rank: [Number(!doesFit), Number(!isMissing), nearness(entry, wanted), order] }
  })
  ranked.sort((a, b) => compared(a.rank, b.rank))
  const shown = ranked.slice(0, MOST)
  const leftOut = named.length - offered.length
  return [
    ...shown.map(({ entry: { name, caption, type }, doesFit }) => ({ name, caption, type, doesFit })),
    ...(leftOut ? [{ name: '', caption: '', type: '', doesFit: true, leftOut }] : []),
  ]
}

/** How many of all icons fit, whatever was typed. */
export const countFitting = (
  entries: readonly Entry[],
  gap: Gap | undefined,
  hardware: readonly string[] = [],
): number => entries.filter((entry) => fits(entry, gap) && !isOfAnotherArm(entry, hardware)).length

/** Less is nearer to what was typed: what is called just so, then what begins so, then by its first word alone. */
function nearness({ name, caption }: Entry, wanted: readonly string[]): number {
  const [word, phrase] = [wanted[0], wanted.join(' ')]
  if (!word) return 0
  const names = [name.toLowerCase(), caption.toLowerCase()]
  if (names.includes(phrase)) return 0
  if (names.some((each) => each.startsWith(phrase))) return 1
  if (names.some((each) => each.startsWith(word))) return 2
  if (names[1].includes(` ${word}`)) return 3
  return names.some((each) => each.includes(word)) ? 4 : 5
}

function compared(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((value, k) => value !== b[k])
  return at < 0 ? 0 : a[at]! - b[at]!
}
