// The cameras of a workcell as they travel: what they are once, then their newest pictures.

/** A camera: how large its pictures are in pixels, and how many it takes in a second. */
export interface CameraKind {
  name: string
  width: number
  height: number
  rate: number
}

/** A picture: its number, when it was taken (s of its world), and what an image shows. */
export interface Picture {
  number: number
  at_s: number
  url: string
}

/** The cameras in an answer to `Scene`. */
export function camerasOf(answer: unknown): CameraKind[] {
  const given = answer as { cameras?: unknown; scene?: { cameras?: unknown } } | null | undefined
  const cameras = given?.cameras ?? given?.scene?.cameras
  return Array.isArray(cameras) ? (cameras as CameraKind[]) : []
}

/** The newest picture as a frame gave it; undefined where there is none. */
export function pictureOf(given: unknown): Picture | undefined {
  const { file, number, at_s } = (given ?? {}) as { file?: unknown; number?: unknown; at_s?: unknown }
  if (typeof file !== 'string' || typeof number !== 'number' || typeof at_s !== 'number') return undefined
  return { number, at_s, url: `data:image/${file.startsWith('iVBOR') ? 'png' : 'jpeg'};base64,${file}` }
}

/** Pictures a second between two of them; undefined where they say nothing. */
export function rateOf(earlier: Picture | undefined, later: Picture): number | undefined {
  const [count, seconds] = earlier ? [later.number - earlier.number, later.at_s - earlier.at_s] : [0, 0]
  return count > 0 && seconds > 0 ? count / seconds : undefined
}

/** The pixel of a picture of this size under a place of the box in which it is shown whole. */
export function pixelUnder(
  place: { x: number; y: number },
  box: { left: number; top: number; width: number; height: number },
  { width, height }: { width: number; height: number },
): [number, number] {
  const u = ((place.x - box.left) / box.width) * width - 0.5
  const v = ((place.y - box.top) / box.height) * height - 0.5
  return [Math.min(Math.max(Math.round(u), 0), width - 1), Math.min(Math.max(Math.round(v), 0), height - 1)]
}
