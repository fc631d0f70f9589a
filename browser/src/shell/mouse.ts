// What the mouse does, as in the tables of the dissertation's appendix B, and what came since.
import type { TextKey } from '../texts/index.svelte'

export const MOUSE: [TextKey, [TextKey, TextKey][]][] = [
  ['mouse.library', [
    ['mouse.left', 'mouse.l.select'],
    ['mouse.leftEmpty', 'mouse.l.deselect'],
    ['mouse.middle', 'mouse.l.sheet'],
    ['mouse.shiftMiddle', 'mouse.l.source'],
    ['mouse.ctrlMiddle', 'mouse.l.rmod'],
  ]],
  ['mouse.canvas', [
    ['mouse.leftTask', 'mouse.c.select'],
    ['mouse.leftLocus', 'mouse.c.locus'],
    ['mouse.leftEmpty', 'mouse.c.deselect'],
    ['mouse.shiftLeftTask', 'mouse.c.toggle'],
    ['mouse.shiftLeftLocus', 'mouse.c.shown'],
    ['mouse.middleTask', 'mouse.c.sheet'],
    ['mouse.middleLocus', 'mouse.c.info'],
    ['mouse.shiftMiddleTask', 'mouse.c.source'],
    ['mouse.shiftMiddleEmpty', 'mouse.c.check'],
    ['mouse.ctrlMiddleTask', 'mouse.c.rmod'],
    ['mouse.right', 'mouse.c.place'],
    ['mouse.wheel', 'mouse.c.zoom'],
  ]],
]
