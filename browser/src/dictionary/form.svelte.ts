// What is filled in of a target or icon: its values as words, and how it fares when it is sent.
import { announce } from '../state/announce'
import type { AnyAct, ItemView, Remedy, TaughtView } from '../api.gen'
import { reveal } from '../act/reveal.svelte'
import { send } from '../link/link'
import { Refusal } from '../link/refusal'
import { complaint, type Field } from '../question/question'
import { askOf, begun, lacking, nested, rowsOf, taken, type Nested } from './values'

/** The values of one type. */
export class ValuesDraft {
  words: string[] = $state([])
  /** Whether what is missing is complained of, too. */
  isAsked = $state(false)
  present: Record<string, number[]> | undefined = $state.raw()
  private items: readonly ItemView[] = $state.raw([])
  readonly rows: readonly Field[] = $derived.by(() => rowsOf(askOf(this.items, this.present)))

  constructor(items: readonly ItemView[], values?: Nested, words?: string[]) {
    this.items = items
    this.words = words ?? begun(rowsOf(askOf(items)), values)
  }

  get values(): string[][] {
    return nested(this.rows, this.words)
  }

  /** The place of the first word that is wrong; -1: none is. */
  get firstWrong(): number {
    return this.rows.findIndex((row, k) => complaint(row, this.words[k] ?? '') !== undefined)
  }

  /** The words of one item; where a constant of the robot says how many there are, there are as many as these. */
  put(name: string, words: readonly string[]): void {
    const before = this.values
    this.items = this.items.map((item) =>
      item.name === name && item.dimension ? { ...item, count: words.length } : item,
    )
    this.words = this.items.flatMap((item, k) => (item.name === name ? [...words] : (before[k] ?? [])))
  }

  /** Take over what was measured, with the bounds that are known now; answers with the names of what still lacks. */
  take({ values }: TaughtView, items: readonly ItemView[] = this.items): string[] {
    const counts = new Map(this.items.map(({ name, count }) => [name, count]))
    if (items.every(({ name, count }) => counts.get(name) === count)) this.items = items
    this.present = values
    this.words = taken(this.rows, this.words, values)
    return lacking(this.rows, values).filter((name) =>
      this.rows.some((row, k) => row.item.name === name && !this.words[k]),
    )
  }
}

/** One thing that is asked of the environment from a panel, and the refusal shown in it. */
export class Sending {
  why: Refusal | undefined = $state.raw()
  isUnderWay = $state(false)

  /** The value of the answer, null where it has none; undefined where it was refused. */
  async send(act: AnyAct): Promise<unknown> {
    this.why = undefined
    this.isUnderWay = true
    try {
      return (await send(act)) ?? null
    } catch (why) {
      if (!(why instanceof Refusal)) throw why
      this.why = why
      announce(why.reason)
      return undefined
    } finally {
      this.isUnderWay = false
    }
  }

  /** Do what a remedy offers; what it sends is answered as `send` is. */
  async follow(remedy: Remedy): Promise<unknown> {
    this.why = undefined
    if (remedy.show) reveal(remedy.show)
    return remedy.act ? this.send(remedy.act) : undefined
  }
}
