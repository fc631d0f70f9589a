// What this browser watches of the running system; see the value buffer for how it is kept. While a recorded run is looked at, all
// of it comes from there.
import { hear, send } from '../link/link'
import { ValueBuffer, type Figures } from './valueBuffer'
import type { Past, Series } from './series'

export type { Figures, Past, Series }

/** Where values come from. */
export interface Source {
  latest(key: string): unknown
  series(key: string): Past | undefined
  poses(world: string): unknown
  readonly figures: Figures
  readonly now_s: number
}

// A watch is no deed of the user: where the line is down it is said again as soon as it is back.
const buffer = new ValueBuffer(
  (wish) => void send(wish).catch(() => undefined),
  (run) => requestAnimationFrame(run),
)
let source: Source = buffer

/** Show what another source has from now on; without one, what runs. */
export function showFrom(other?: Source): void {
  source = other ?? buffer
  stir()
}
/** The source has something else to show. */
export const stir = (): void => buffer.stir()

export const watch = (key: string): (() => void) => buffer.watch(key)
export const watchWorld = (name: string): (() => void) => buffer.watchWorld(name)
export const watchFigures = (): (() => void) => buffer.watchFigures()
export const latest = (key: string): unknown => source.latest(key)
export const series = (key: string): Past | undefined => source.series(key)
export const poses = (world: string): unknown => source.poses(world)
export const figures = (): Figures => source.figures
export const now = (): number => source.now_s
export function onFrame(listen: () => void): () => void {
  const end = buffer.onFrame(listen)
  if (source !== buffer) stir() // what does not run sends nothing by itself
  return end
}
/** Ask for everything watched anew, as Refresh does. */
export const watchAgain = (): void => buffer.again()

hear('Frame', (frame) => buffer.receive(frame))
hear('Snapshot', () => buffer.again())
