/** The small picture of a whole scene, in which the user sees what part is on the screen and jumps about. */

import { overlaps, union, type Area, type Pt, type Rect } from './rect'
import { seen, toScene, type Size, type View } from './viewport'

export interface Minimap {
  /** From the scene to the small picture, as a view. */
  readonly view: View
  readonly size: Size
}

/** The scene and what is on the screen, scaled into a small picture with a margin. */
export function minimap(areas: Iterable<Area>, onScreen: Area, size: Size, margin = 4): Minimap {
  const all = union([...areas, onScreen])!
  const [w, h] = [Math.max(all.x1 - all.x0, 1), Math.max(all.y1 - all.y0, 1)]
  const scale = Math.min((size.w - 2 * margin) / w, (size.h - 2 * margin) / h)
  const x = size.w / 2 - ((all.x0 + all.x1) / 2) * scale
  return { size, view: { scale, x, y: size.h / 2 - ((all.y0 + all.y1) / 2) * scale } }
}

/** An area of the scene in the small picture; nothing becomes too small to be seen. */
export function shrunk({ view }: Minimap, area: Area): Rect {
  return {
    x: area.x0 * view.scale + view.x,
    y: area.y0 * view.scale + view.y,
    w: Math.max((area.x1 - area.x0) * view.scale, 1),
    h: Math.max((area.y1 - area.y0) * view.scale, 1),
  }
}

/** The view that brings the point of the scene under a click on the small picture to the middle of the screen. */
export function jumped(map: Minimap, click: Pt, view: View, screen: Size): View {
  const [x, y] = toScene(map.view, click)
  return { ...view, x: screen.w / 2 - x * view.scale, y: screen.h / 2 - y * view.scale }
}

/** Whether something of the scene lies under a place of the screen. */
export function covers(place: Rect, areas: Iterable<Area>, view: View): boolean {
  const [x0, y0] = toScene(view, [place.x, place.y])
  const [x1, y1] = toScene(view, [place.x + place.w, place.y + place.h])
  for (const area of areas) if (overlaps(area, { x0, y0, x1, y1 })) return true
  return false
}

/** Whether the small picture is worth its place: many boxes, or one that is off the screen. */
export function wanted(boxes: readonly Area[], view: View, screen: Size, many = 40): boolean {
  const shown = seen(view, screen)
  return boxes.length > many || boxes.some((box) => !overlaps(box, shown))
}
