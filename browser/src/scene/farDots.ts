// Dots of loci from afar, joined to one outline for each look.
import type { LocusView } from '../api.gen'

/** A dot as a piece of a path. */
export interface FarDot {
  readonly svar: string
  readonly d: string
}

export interface DotOutline {
  /** What it looks like, as a dot of its own does by its classes. */
  readonly look: string
  d: string
}

/** `size`: of its radius, in pixels of the scene. */
export const farDot = (svar: string, x: number, y: number, size: number): FarDot => ({
  svar,
  d: `M${x - size} ${y}a${size} ${size} 0 1 0 ${2 * size} 0a${size} ${size} 0 1 0 ${-2 * size} 0`,
})

/** What a locus looks like: by who writes it, and whether its lines are shown. */
export function lookOf({ line = 'idle', is_shown = true, is_constant = false }: LocusView): string {
  if (is_shown) return line
  return is_constant ? 'shut' : `${line} closed`
}

/** The outlines of these dots by their looks, in the order in which the looks come. */
export function dotOutlines(dots: readonly FarDot[], loci: Readonly<Record<string, LocusView>>): DotOutline[] {
  const byLook = new Map<string, DotOutline>()
  for (const { svar, d } of dots) {
    const locus = loci[svar]
    if (!locus) continue
    const look = lookOf(locus)
    const outline = byLook.get(look)
    if (outline) outline.d += d
    else byLook.set(look, { look, d })
  }
  return [...byLook.values()]
}
