// What this browser watches of the running system; see the reel for how it is kept.
import { hear, send } from './link'
import { Reel, type Figures } from './run/reel'
import type { Series } from './run/series'

export type { Figures, Series }

// A watch is no deed of the user: where the line is down it is said again as soon as it is back.
const reel = new Reel(
  (wish) => void send(wish).catch(() => undefined),
  (run) => requestAnimationFrame(run),
)

export const watch = (key: string): (() => void) => reel.watch(key)
export const watchWorld = (name: string): (() => void) => reel.watchWorld(name)
export const watchFigures = (): (() => void) => reel.watchFigures()
export const latest = (key: string): unknown => reel.latest(key)
export const series = (key: string): Series | undefined => reel.series(key)
export const poses = (world: string): unknown => reel.poses(world)
export const figures = (): Figures => reel.figures
export const now = (): number => reel.now_s
export const onFrame = (listen: () => void): (() => void) => reel.onFrame(listen)
/** Ask for everything watched anew, as Refresh does. */
export const watchAgain = (): void => reel.again()

hear('Frame', (frame) => reel.receive(frame))
hear('Snapshot', () => reel.again())
