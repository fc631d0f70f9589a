// The line of time of a recorded run: its actions as blocks in lanes, what happened as marks, and where its actions begin.
import type { MarkView, PassageView, RecordedFlowView, RecordingView } from '../api.gen'
import type { Block } from '../progress/past'

export interface Lane {
  subsystem: string
  order: number
  passages: readonly PassageView[]
}

/** The flows in their order. */
export function lanesOf(recording: RecordingView): Lane[] {
  return Object.entries(recording.flows ?? {})
    .map(([subsystem, { order, passages = [] }]: [string, RecordedFlowView]) => ({ subsystem, order, passages }))
    .sort((flow, other) => flow.order - other.order)
}

/** When it ends: a run that was cut short ends with the last thing that it tells. */
export const endOf = (recording: RecordingView): number => Math.max(recording.end_s ?? 0, recording.begin_s ?? 0)

/** Where actions begin, in the order of time, each moment once; the beginning of the run is one of them. */
export function beginnings(recording: RecordingView): number[] {
  const all = lanesOf(recording).flatMap((lane) => lane.passages.map((passage) => passage.begin_s))
  return [...new Set([recording.begin_s ?? 0, ...all])].sort((moment, other) => moment - other)
}

/** The steps of the application that its actions are, as one word. */
export const stepsOf = (recording: RecordingView | undefined): string =>
  recording
    ? `${recording.doc}: ${lanesOf(recording)
        .flatMap((lane) => lane.passages.map((passage) => passage.step))
        .join()}`
    : ''

const HERE_S = 1e-6

/** The moment next to one, in either direction; undefined where there is none. */
export function nextTo(moments: readonly number[], at_s: number, way: 1 | -1): number | undefined {
  return way > 0
    ? moments.find((moment) => moment > at_s + HERE_S)
    : moments.findLast((moment) => moment < at_s - HERE_S)
}

/** What a flow carried out at an instant. */
export const passageAt = ({ passages }: Lane, at_s: number): PassageView | undefined =>
  passages.findLast((passage) => passage.begin_s <= at_s + HERE_S && (passage.end_s == null || at_s < passage.end_s))

/** The actions up to an instant as the run panel draws them: one that is carried out then has no end; `stopped` are flows that stand still. */
export function blocksUntil(recording: RecordingView, at_s: number, stopped: ReadonlySet<number> = new Set()): Block[] {
  return lanesOf(recording)
    .flatMap((lane) =>
      lane.passages
        .filter((passage) => passage.begin_s <= at_s)
        .map((passage, n): Block => {
          const isGoing = passage.end_s == null || passage.end_s > at_s
          const isFault = isGoing && stopped.has(lane.order)
          return {
            key: `${lane.order}/${n}`,
            kind: 'action',
            flow: lane.order,
            step: passage.step ?? 0,
            from_s: passage.begin_s,
            to_s: isGoing ? NaN : passage.end_s!,
            isFault,
          }
        }),
    )
    .sort((block, other) => block.from_s - other.from_s)
}

export interface Tick {
  x: number
  marks: readonly MarkView[]
  /** The gravest of them. */
  kind: MarkView['kind']
}

const GRAVITY: readonly MarkView['kind'][] = ['command', 'meet', 'error', 'stop']
const APART_PX = 7

/** Marks that would lie upon each other are one tick. */
export function ticksOf(marks: readonly MarkView[], at: (at_s: number) => number): Tick[] {
  const ticks: { x: number; marks: MarkView[] }[] = []
  for (const mark of [...marks].sort((mark, other) => mark.at_s - other.at_s)) {
    const [x, last] = [at(mark.at_s), ticks.at(-1)]
    if (last && x - last.x < APART_PX) last.marks.push(mark)
    else ticks.push({ x, marks: [mark] })
  }
  return ticks.map((tick) => ({
    ...tick,
    kind: tick.marks.map((mark) => mark.kind).sort((kind, other) => GRAVITY.indexOf(other) - GRAVITY.indexOf(kind))[0]!,
  }))
}
