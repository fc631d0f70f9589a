// The ghost of an arm that the values of a target move while they are chosen.
import type { Ghost } from '../state/ghost.svelte'
import { complaint, type Field } from '../question/question'
import { isOfPose } from './values'

/** What was taken of an arm. */
export interface TakenOfArm {
  /** The arm, as `WORLD:NAME`; empty: of none. */
  device: string
  /** The data that say where it goes, with the words that were taken. */
  words: Readonly<Record<string, string>>
  /** Its joints, where a pose says where it goes. */
  joints: readonly number[]
}

export const NOTHING_TAKEN: TakenOfArm = { device: '', words: {}, joints: [] }

/** The words of these data, by name. */
export function wordsOf(
  rows: readonly Field[],
  words: readonly string[],
  names: readonly string[],
): Record<string, string> {
  const own = (name: string): string => words.filter((_, k) => rows[k]?.item.name === name).join(' ')
  return Object.fromEntries(names.map((name) => [name, own(name)]))
}

/** The arm where these words bring it: joints follow each word, a pose only as it was taken. */
export function ghostOf(rows: readonly Field[], words: readonly string[], taken: TakenOfArm): Ghost | undefined {
  const { device } = taken
  if (!device) return undefined
  const own = rows.map((row, k) => ({ row, word: words[k] ?? '' })).filter(({ row }) => row.item.name in taken.words)
  if (own.some(({ row }) => isOfPose(row))) {
    const now = wordsOf(rows, words, Object.keys(taken.words))
    const isAsTaken = Object.entries(taken.words).every(([name, text]) => now[name] === text)
    return isAsTaken && taken.joints.length ? { device, joints: taken.joints, isBeyond: false } : undefined
  }
  const joints = own.map(({ word }) => Number(word))
  const isWhole = own.length > 0 && own.every(({ word }) => word.trim()) && joints.every(Number.isFinite)
  const isBeyond = own.some(({ row, word }) => complaint(row, word) !== undefined)
  return isWhole ? { device, joints, isBeyond } : undefined
}
