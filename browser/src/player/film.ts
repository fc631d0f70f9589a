// A recorded run out of a shared file: what it was like at each of its instants. It answers what an environment would.
import type { InstantView, RunView, StretchView, Tree } from '../api.gen'
import { Blocks, type BlockPlace } from './blocks'

interface Numbers {
  first: number
  dims?: number[]
  values?: number
  least?: number
  most?: number
}
type Change<Value> = [place: number, value: Value]
interface Words {
  changes: Change<unknown>[]
}
interface RecordedWorld {
  shapes: unknown[]
  stretches: { first: number; poses: number }[]
  lit: Change<string[]>[]
}
type Path = readonly string[]
/** What stands before the numbers. */
export interface Head {
  format: number
  version: string
  period_s: number
  tree: Tree
  instants: number
  run: { first: RunView; changes: Change<[Path, unknown][]>[] }
  states: Change<Record<string, string>>[]
  variables: Record<string, Numbers | Words>
  worlds: Record<string, RecordedWorld>
  meshes: Record<string, number>
  blocks: BlockPlace[]
}

const HEAD = 8 // bytes that say how long the head is
const HERE_S = 5e-10
const NOTHING = new Uint32Array(new Float32Array([NaN]).buffer)[0]!

export class Film {
  readonly head: Head
  readonly at_s: Float64Array
  private readonly blocks: Blocks
  private readonly runs: Change<RunView>[]
  private readonly states: Change<Record<string, string>>[]
  private readonly peaks = new Map<string, { least: Float32Array[]; most: Float32Array[] }>()

  constructor(whole: Uint8Array<ArrayBuffer>) {
    const length = Number(new DataView(whole.buffer, whole.byteOffset, HEAD).getBigUint64(0, true))
    this.head = JSON.parse(new TextDecoder().decode(whole.subarray(HEAD, HEAD + length))) as Head
    this.blocks = new Blocks(this.head.blocks, whole.subarray(HEAD + length))
    this.at_s = this.blocks.doubles(this.head.instants)[0] ?? new Float64Array()
    this.runs = folded(this.head.run.first, this.head.run.changes, (run, changes) => changes.reduce(changed, run))
    this.states = folded({} as Record<string, string>, this.head.states, (all, some) => ({ ...all, ...some }))
  }

  /** The last instant that is not after a time; before all of them the first. */
  placeOf(at_s: number): number {
    return Math.max(
      0,
      lastBefore(this.at_s.length, (k) => this.at_s[k]! <= at_s + HERE_S),
    )
  }

  instant(at_s: number): InstantView {
    const place = this.placeOf(at_s)
    const values: Record<string, unknown> = {}
    for (const name of Object.keys(this.head.variables)) {
      const value = this.value(name, place)
      if (value !== undefined) values[name] = value
    }
    return {
      at_s: this.at_s[place] ?? 0,
      run: newest(this.runs, place)!,
      tasks: newest(this.states, place) ?? {},
      values,
      poses: Object.fromEntries(Object.keys(this.head.worlds).flatMap((world) => this.poses(world, place))),
      homes: {},
    }
  }

  /** What a world consisted of; undefined where it is not in the file. */
  scene(world: string): { shapes: unknown[] } | undefined {
    const recorded = this.head.worlds[world]
    return recorded && { shapes: recorded.shapes }
  }

  /** A mesh by the name of its content. */
  mesh(name: string): ArrayBuffer | undefined {
    const block = this.head.meshes[name]
    return block === undefined ? undefined : this.blocks.bytes(block)
  }

  /** A variable in so many equal parts of a time, in each the least and the greatest value; undefined: it is not there. */
  course(name: string, begin_s: number, end_s: number, points = 800): StretchView[] | undefined {
    const about = this.head.variables[name]
    const view = this.head.tree.review?.recording.variables?.[name]
    if (!about) return undefined
    if (!('first' in about) || about.values === undefined) return []
    const { least, most } = this.extremes(name, about)
    const from = Math.max(0, this.placeOf(begin_s) - about.first)
    const to = Math.min(least[0]!.length - 1, this.placeOf(end_s) - about.first)
    const width_s = Math.max((end_s - begin_s) / points, 1e-9)
    const starts: number[] = []
    const times: number[] = []
    for (let k = from, last = -1; k <= to; k += 1) {
      const part = Math.floor(Math.max(0, this.at_s[about.first + k]! - begin_s) / width_s)
      if (part === last) continue
      starts.push(k)
      times.push(begin_s + part * width_s)
      last = part
    }
    const ends = [...starts.slice(1), to + 1]
    const labels = view?.labels?.length ? view.labels : least.map((_, k) => `${name}[${k}]`)
    return least.map((row, k) => ({
      label: labels[k] ?? '',
      unit: view?.unit ?? '',
      at_s: times,
      least: starts.map((start, n) => between(row, start, ends[n]!, -1)),
      most: starts.map((start, n) => between(most[k]!, start, ends[n]!, 1)),
    }))
  }

  private value(name: string, place: number): unknown {
    const about = this.head.variables[name]!
    if (!('first' in about)) return newest(about.changes, place)
    if (about.values === undefined || place < about.first) return undefined
    const row = this.blocks.doubles(about.values).map((column) => plainNumber(column[place - about.first]!))
    return nested(row, about.dims ?? [])
  }

  private poses(world: string, place: number): [string, unknown][] {
    const { stretches, lit } = this.head.worlds[world]!
    const stretch = stretches.findLast(({ first }) => first <= place)
    if (!stretch) return []
    const rows = this.blocks
      .floats(stretch.poses)
      .map((column) => column[Math.min(place - stretch.first, column.length - 1)]!)
    return [[world, { rows, lit: newest(lit, place) ?? [] }]]
  }

  /** From each instant to the next the least and the greatest value: what its ends let expect, but for the bits that differ. */
  private extremes(name: string, about: Numbers): { least: Float32Array[]; most: Float32Array[] } {
    const before = this.peaks.get(name)
    if (before) return before
    const values = this.blocks.doubles(about.values!)
    const along = (block: number, choose: (one: number, other: number) => number): Float32Array[] =>
      this.blocks.floats(block).map((apart, k) => beside(values[k]!, apart, choose))
    const made = { least: along(about.least!, lesser), most: along(about.most!, greater) }
    this.peaks.set(name, made)
    return made
  }
}

function beside(
  values: Float64Array,
  apart: Float32Array,
  choose: (one: number, other: number) => number,
): Float32Array {
  const row = new Float32Array(values.length)
  values.forEach((value, k) => (row[k] = choose(value, values[Math.min(k + 1, values.length - 1)]!)))
  const [bits, other] = [new Uint32Array(row.buffer), new Uint32Array(apart.buffer)]
  for (let k = 0; k < bits.length; k += 1) bits[k] = (Number.isNaN(row[k]) ? NOTHING : bits[k]!) ^ other[k]!
  return row
}

const lesser = (one: number, other: number): number => (Number.isNaN(one) || other < one ? other : one)
const greater = (one: number, other: number): number => (Number.isNaN(one) || other > one ? other : one)
/** JSON knows none that is no number or without end. */
const plainNumber = (value: number): number | null => (Number.isFinite(value) ? value : null)

function between(row: Float32Array, from: number, to: number, sign: 1 | -1): number {
  let best = row[from]!
  for (let k = from + 1; k < to; k += 1) if (Number.isNaN(best) || sign * row[k]! > sign * best) best = row[k]!
  return best
}

/** Elements row by row as lists as deep as their shape. */
function nested(row: readonly unknown[], dims: readonly number[]): unknown {
  if (!dims.length) return row[0]
  let parts: readonly unknown[] = row
  for (const size of dims.slice(1).reverse())
    parts = Array.from({ length: parts.length / size }, (_, k) => parts.slice(k * size, (k + 1) * size))
  return parts
}

/** How often something holds, where it holds up to a place and not behind it; less one. */
function lastBefore(count: number, holds: (k: number) => boolean): number {
  let [low, high] = [0, count]
  while (low < high) {
    const middle = (low + high) >> 1
    if (holds(middle)) low = middle + 1
    else high = middle
  }
  return low - 1
}

function newest<Value>(changes: readonly Change<Value>[], place: number): Value | undefined {
  return changes[lastBefore(changes.length, (k) => changes[k]![0] <= place)]?.[1]
}

/** What it was after each change. */
function folded<Value, Step>(
  first: Value,
  changes: readonly Change<Step>[],
  after: (value: Value, step: Step) => Value,
): Change<Value>[] {
  const all: Change<Value>[] = [[-1, first]]
  for (const [place, step] of changes) all.push([place, after(all.at(-1)![1], step)])
  return all
}

/** The same with something else at one place; what is not on the way to it stays the same object. */
function changed(whole: RunView, [path, value]: [Path, unknown]): RunView {
  return at(whole as unknown as Record<string, unknown>, path, value) as unknown as RunView
}

function at(branch: Record<string, unknown>, path: Path, value: unknown): Record<string, unknown> {
  const [name = '', ...rest] = path
  if (rest.length) return { ...branch, [name]: at((branch[name] ?? {}) as Record<string, unknown>, rest, value) }
  if (value !== null) return { ...branch, [name]: value }
  return Object.fromEntries(Object.entries(branch).filter(([other]) => other !== name))
}
