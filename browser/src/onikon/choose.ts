// Which icons are shown, and in which groups: one dictionary or all, what was searched for, what fits.
import type { DictionaryView, OnikonView, TypeView } from '../api.gen'
import { fits, isOfAnotherArm, type Gap } from './fits'
import { wordsOf } from './words'

/** An icon as the search sees it. */
export interface Entry {
  readonly name: string
  readonly type: string
  readonly dictionary: string
  readonly left: string
  /** Of a target: the task of the arm that it was made for; empty: any. */
  readonly arm: string
  readonly caption: string
  /** What is searched, in small letters. */
  readonly text: string
}

export interface Group {
  readonly type: string
  readonly names: string[]
  /** The left edge of its icons. */
  readonly left: string
}

/** Whether the icons of a group fit at the place where the next one goes; `hole`: they are what is missing there. */
export type Fit = '' | 'here' | 'hole'

export interface Wish {
  /** The dictionary's path; empty: all. */
  readonly dictionary: string
  readonly wanted: string
  /** The left edge of those that fit, where no others are wanted. */
  readonly left: string | undefined
  /** The tasks with a device of the job for which targets are wanted; none: those of every arm are. */
  readonly hardware?: readonly string[]
}

/** All icons in the order of the syntax's types, of the dictionaries, those that are shipped first, and within these. */
export function inOrder(
  onikons: Readonly<Record<string, OnikonView>>,
  types: Readonly<Record<string, TypeView>>,
  dictionaries: Readonly<Record<string, DictionaryView>>,
  language: string,
): Entry[] {
  const places = new Map(Object.values(dictionaries).map((dictionary) => [dictionary.path, dictionary.order]))
  const shipped = new Set(Object.values(dictionaries).flatMap(({ path, is_shipped }) => (is_shipped ? [path] : [])))
  const arranged = new Map(
    Object.values(dictionaries).map(({ path, arranged }) => [
      path,
      new Map(arranged?.map((name, place) => [name, place])),
    ]),
  )
  const rank = (name: string, onikon: OnikonView): number[] => [
    types[onikon.type]?.order ?? Infinity,
    Number(!shipped.has(onikon.dictionary)), // what is shipped keeps its places when somebody makes an icon
    places.get(onikon.dictionary) ?? Infinity,
    arranged.get(onikon.dictionary)?.get(name) ?? Infinity,
    onikon.order,
  ]
  const rows = Object.entries(onikons).map(([name, onikon]) => ({
    rank: rank(name, onikon),
    entry: entryOf(name, onikon, language),
  }))
  return rows.sort((a, b) => compared(a.rank, b.rank)).map(({ entry }) => entry)
}

function entryOf(name: string, onikon: OnikonView, language: string): Entry {
  const { type, dictionary, left, arm = '' } = onikon
  const caption = wordsOf(onikon, name, language)
  const text = [name, type, onikon.description ?? '', ...Object.values(onikon.words ?? {})].join('\n').toLowerCase()
  return { name, type, dictionary, left, arm, caption, text }
}

function compared(a: readonly number[], b: readonly number[]): number {
  const at = a.findIndex((value, k) => value !== b[k])
  return at < 0 ? 0 : a[at]! < b[at]! ? -1 : 1
}

/** What is wished for, in groups of one type each. */
export function choose(entries: readonly Entry[], { dictionary, wanted, left, hardware = [] }: Wish): Group[] {
  const words = wanted.trim().toLowerCase().split(/\s+/).filter(Boolean)
  const isChosen = (entry: Entry): boolean =>
    (words.length > 0 || !dictionary || entry.dictionary === dictionary) &&
    words.every((word) => entry.text.includes(word)) &&
    (left === undefined || entry.left === left) &&
    !isOfAnotherArm(entry, hardware)
  const groups = new Map<string, Entry[]>()
  for (const entry of entries)
    if (isChosen(entry)) groups.get(entry.type)?.push(entry) ?? groups.set(entry.type, [entry])
  return [...groups].map(([type, some]) => ({
    type,
    names: sorted(some, words[0]).map((entry) => entry.name),
    left: some[0]!.left,
  }))
}

/** How many icons groups have. */
export const countIn = (groups: readonly Group[]): number => groups.reduce((sum, { names }) => sum + names.length, 0)

/** Names and words that begin with what was typed come first. */
function sorted(some: readonly Entry[], word: string | undefined): readonly Entry[] {
  if (!word) return some
  const begins = (entry: Entry): number =>
    entry.name.toLowerCase().startsWith(word) || entry.caption.toLowerCase().startsWith(word) ? 0 : 1
  return [...some].sort((a, b) => begins(a) - begins(b))
}

export function fitOf(group: Group, gap: Gap | undefined): Fit {
  if (!gap || !fits(group, gap)) return ''
  return gap.isHole && gap.wants.includes(group.type) ? 'hole' : 'here'
}
