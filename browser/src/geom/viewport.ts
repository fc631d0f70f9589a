/** What part of a scene is seen and how large: an immutable view, moved and scaled by the functions here. */

import { union, type Area, type Pt } from './rect'

/** A point p of the scene appears at p · scale + (x, y). */
export interface View {
  readonly x: number
  readonly y: number
  readonly scale: number
}

export interface Size {
  readonly w: number
  readonly h: number
}

export const PLAIN: View = { x: 0, y: 0, scale: 1 }
export const LEAST = 0.1
export const MOST = 4

export const toScreen = (view: View, [x, y]: Pt): Pt => [x * view.scale + view.x, y * view.scale + view.y]

export const toScene = (view: View, [x, y]: Pt): Pt => [(x - view.x) / view.scale, (y - view.y) / view.scale]

/** Move by pixels of the screen. */
export const panned = (view: View, dx: number, dy: number): View => ({ ...view, x: view.x + dx, y: view.y + dy })

/** Scale by a factor; the point of the scene under the pointer stays there. */
export const zoomed = (view: View, factor: number, pointer: Pt): View => zoomedTo(view, view.scale * factor, pointer)

export function zoomedTo(view: View, scale: number, pointer: Pt): View {
  const to = Math.min(Math.max(scale, LEAST), MOST)
  const [x, y] = toScene(view, pointer)
  return { scale: to, x: pointer[0] - x * to, y: pointer[1] - y * to }
}

/** The factor of a wheel event: the same way forth and back, however it is cut into events. */
export const wheelFactor = (deltaY: number): number => Math.exp(-deltaY / 400)

/** The view that shows all areas with a margin, as large as they fit, but not larger than `most`. */
export function fitted(areas: Iterable<Area>, screen: Size, margin = 40, most = 1): View {
  const all = union(areas)
  if (!all) return PLAIN
  const room = { w: Math.max(screen.w - 2 * margin, 1), h: Math.max(screen.h - 2 * margin, 1) }
  const fit = Math.min(room.w / Math.max(all.x1 - all.x0, 1), room.h / Math.max(all.y1 - all.y0, 1), most)
  const scale = Math.min(Math.max(fit, LEAST), MOST)
  return { scale, x: screen.w / 2 - ((all.x0 + all.x1) / 2) * scale, y: screen.h / 2 - ((all.y0 + all.y1) / 2) * scale }
}

/** The view moved as little as possible so that an area is seen with a margin; of too large a one the upper left. */
export function revealed(view: View, area: Area, screen: Size, margin = 20): View {
  const [x0, y0] = toScreen(view, [area.x0, area.y0])
  const [x1, y1] = toScreen(view, [area.x1, area.y1])
  return panned(view, shiftInto(x0, x1, margin, screen.w - margin), shiftInto(y0, y1, margin, screen.h - margin))
}

function shiftInto(from: number, to: number, least: number, most: number): number {
  if (from < least || to - from > most - least) return least - from
  return to > most ? most - to : 0
}

/** The part of the scene that is on the screen. */
export function seen(view: View, screen: Size): Area {
  const [x0, y0] = toScene(view, [0, 0])
  const [x1, y1] = toScene(view, [screen.w, screen.h])
  return { x0, y0, x1, y1 }
}
