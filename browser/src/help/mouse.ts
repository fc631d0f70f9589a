// What the mouse does, as in the tables of the dissertation's appendix B, and what came since.
import type { Level } from '../state/look.svelte'
import type { TextKey } from '../texts/index.svelte'

export type Table = [TextKey, [TextKey, TextKey][]]

const LOWER: Table[] = [
  [
    'mouse.library',
    [
      ['mouse.left', 'mouse.l.select'],
      ['mouse.leftEmpty', 'mouse.l.deselect'],
      ['mouse.middle', 'mouse.l.sheet'],
      ['mouse.shiftMiddle', 'mouse.l.source'],
      ['mouse.ctrlMiddle', 'mouse.l.rmod'],
    ],
  ],
  [
    'mouse.canvas',
    [
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
    ],
  ],
]

const UPPER: Table[] = [
  [
    'mouse.dictionary',
    [
      ['mouse.leftIcon', 'mouse.d.select'],
      ['mouse.leftEmpty', 'mouse.d.deselect'],
      ['mouse.doubleIcon', 'mouse.d.insert'],
      ['mouse.shiftLeftJob', 'mouse.d.configuration'],
      ['mouse.shiftLeftApplication', 'mouse.d.application'],
      ['mouse.middleAction', 'mouse.d.types'],
      ['mouse.middleTarget', 'mouse.d.values'],
      ['mouse.shiftMiddleIcon', 'mouse.d.picture'],
      ['mouse.restJob', 'mouse.d.card'],
    ],
  ],
  [
    'mouse.workspace',
    [
      ['mouse.leftIcon', 'mouse.w.select'],
      ['mouse.leftEmpty', 'mouse.w.deselect'],
      ['mouse.right', 'mouse.w.insert'],
      ['mouse.dragIcon', 'mouse.w.move'],
      ['mouse.shiftLeftJob', 'mouse.d.configuration'],
      ['mouse.shiftLeftApplication', 'mouse.d.application'],
      ['mouse.middleAction', 'mouse.d.types'],
      ['mouse.middleTarget', 'mouse.d.values'],
      ['mouse.shiftMiddleIcon', 'mouse.d.picture'],
    ],
  ],
]

/** What leads to the lower level means nothing where that is hidden. */
const LOWER_ONLY: readonly TextKey[] = ['mouse.d.configuration']

/** What draws pictures means nothing where none are shown. */
const DRAWING: readonly TextKey[] = ['mouse.d.picture']

/** The tables of a level; `isUpperOnly`: there is no lower one; `isWithoutPictures`: nobody sees any. */
export function mouse(level: Level, isUpperOnly = false, isWithoutPictures = false): Table[] {
  if (level === 'tasks') return LOWER
  const idle = [...(isUpperOnly ? LOWER_ONLY : []), ...(isWithoutPictures ? DRAWING : [])]
  return UPPER.map(([title, rows]) => [title, rows.filter(([, what]) => !idle.includes(what))])
}
