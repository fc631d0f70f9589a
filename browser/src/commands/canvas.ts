// The commands of the canvas, for keys, palette and help sheet (table B.2).
import { command, type Command } from '../state/commands'
import { closesFirst } from '../state/layers'
import { canvas } from '../state/canvas.svelte'
import { t, type TextKey } from '../texts/index.svelte'
import {
  align,
  arrange,
  check,
  copy,
  cut,
  deselect,
  flip,
  openSheet,
  paste,
  pickedTasks,
  placeInMiddle,
  remove,
  selectAll,
  toggle,
  toggleConstants,
  toggleLines,
  turn,
  turnAll,
  type Edge,
} from '../scene/acts'
import {
  askForChange,
  askForName,
  openInsert,
  openSaving,
  pickedGroups,
  selectGroup,
  toggleGroup,
  turnGroup,
  ungroup,
} from '../group/grouping'
import { focusedGroup, focusedLocus, focusedTask } from '../canvas/keys'
import { canvasState } from '../scene/canvasState.svelte'

type Given = Omit<Command, 'id' | 'title' | 'group'> & { group?: Command['group'] }

function add(id: string, title: TextKey, given: Given): void {
  command({ group: 'canvas', level: 'tasks', ...given, id: `canvas.${id}`, title: () => t(title) })
}

const isHere = (): boolean => canvasState.document !== undefined && canvasState.hasKeyboard
const isPicked = (): boolean => isHere() && pickedTasks().length > 0
/** Text that is marked somewhere on the page is what Ctrl+C then means. */
const isNoText = (): boolean => window.getSelection()?.isCollapsed ?? true
const isFocused = (): boolean => (focusedTask() || focusedLocus() || focusedGroup()) !== ''
const isGrouped = (): boolean => pickedGroups().length > 0
const live = (): boolean => canvasState.isLive && pickedTasks().length > 0

/** Where a click would have been: on the thing that the keyboard is on, else in the middle. */
function pointed(): { x: number; y: number } {
  if (canvasState.pointer) return canvasState.pointer
  const { left, top, size } = canvasState.view
  return { x: left + size.w / 2 - 140, y: top + size.h / 3 }
}

function focusPoint(): { x: number; y: number } | undefined {
  const rect = canvasState.rectOf(canvasState.focus)
  if (!rect) return undefined
  const [x, y] = canvasState.view.toClient(rect.x + rect.w, rect.y)
  return { x, y }
}

function openFocused(): void {
  const [task, svar] = [focusedTask(), focusedLocus()]
  const at = focusPoint() ?? pointed()
  if (focusedGroup()) selectGroup(focusedGroup())
  else if (task) openSheet(task)
  else if (svar) canvasState.opened = { kind: 'locus', at, svar }
}

function toggleFocused(): void {
  if (focusedGroup()) toggleGroup(focusedGroup(), focusPoint())
  else if (focusedTask()) toggle(focusedTask(), focusPoint())
  else toggleLines(focusedLocus())
}

function turnGroups(isOn: boolean): void {
  for (const group of pickedGroups()) turnGroup(group, isOn)
}

function registerCanvas(): void {
  add('add', 'canvas.addTask', {
    keys: ['/'],
    when: isHere,
    run: () => (canvasState.opened = { kind: 'quick', at: pointed() }),
  })
  add('placeAtCentre', 'canvas.placeSelected', {
    when: () => canvas.libraryTask !== '',
    run: () => placeInMiddle(canvas.libraryTask),
  })
  add('open', 'canvas.parameters', { keys: ['Enter'], when: () => isHere() && isFocused(), run: openFocused })
  add('toggle', 'canvas.toggle', { keys: ['Shift+Enter'], when: () => isHere() && isFocused(), run: toggleFocused })
  add('cut', 'canvas.cutPicked', {
    group: 'edit',
    keys: ['Delete', 'Backspace', 'Ctrl+X'],
    when: () => isPicked() && isNoText(),
    run: () => cut(),
  })
  add('copy', 'canvas.copy', {
    group: 'edit',
    keys: ['C', 'Ctrl+C'],
    when: () => isPicked() && isNoText(),
    run: () => copy(),
  })
  add('paste', 'canvas.paste', { group: 'edit', keys: ['V'], when: isHere, run: () => paste() }) // Ctrl+V comes as an event of its own
  add('remove', 'canvas.delete', { group: 'edit', when: isPicked, run: () => remove() })
  add('flip', 'canvas.flip', { group: 'edit', keys: ['R'], when: isPicked, run: () => flip() })
  add('selectAll', 'canvas.selectAll', { group: 'edit', keys: ['Ctrl+A'], when: isHere, run: selectAll })
  add('deselect', 'canvas.deselect', {
    group: 'edit',
    keys: ['Escape'],
    when: () => isHere() && !closesFirst() && (canvas.picked.size > 0 || canvas.pickedLocus !== ''),
    run: deselect,
  })
  for (const edge of ['left', 'right', 'top', 'bottom', 'columns', 'rows'] satisfies Edge[])
    add(`align.${edge}`, `canvas.align.${edge}`, {
      group: 'edit',
      when: () => pickedTasks().length > 1,
      run: () => align(edge),
    })
  add('arrange', 'canvas.arrange', { group: 'edit', when: isHere, run: () => arrange() })
  add('nudge', 'canvas.nudge', { keys: ['←↑→↓', 'Shift+←↑→↓'], when: () => false, run: () => undefined }) // for the help sheet; see keys.ts
  add('walk', 'canvas.walk', { keys: ['Alt+←↑→↓'], when: () => false, run: () => undefined })
  add('pick', 'canvas.pick', { keys: ['Space'], when: () => false, run: () => undefined })
  add('on', 'canvas.turnOn', { group: 'run', when: live, run: () => turn(pickedTasks(), true) })
  add('off', 'canvas.turnOff', { group: 'run', when: live, run: () => turn(pickedTasks(), false) })
  add('allOn', 'canvas.allOn', { group: 'run', when: () => canvasState.isLive, run: () => turnAll(true) })
  add('allOff', 'canvas.allOff', { group: 'run', when: () => canvasState.isLive, run: () => turnAll(false) })
  add('group', 'canvas.group.makeIt', {
    group: 'edit',
    keys: ['Ctrl+G'],
    when: () => isHere() && pickedTasks().length > 1,
    run: () => askForName(),
  })
  add('changeGroup', 'canvas.group.change', {
    group: 'edit',
    when: () => pickedGroups().length === 1,
    run: () => askForChange(pickedGroups()[0]!),
  })
  add('ungroup', 'canvas.group.expand', {
    group: 'edit',
    keys: ['Ctrl+Shift+G'],
    when: () => isHere() && isGrouped(),
    run: () => ungroup(),
  })
  add('saveGroup', 'canvas.group.save', {
    group: 'file',
    when: () => pickedGroups().length === 1,
    run: () => openSaving(pickedGroups()[0]!),
  })
  add('insert', 'canvas.group.insert', {
    group: 'file',
    when: () => canvasState.document !== undefined,
    run: () => openInsert(),
  })
  add('groupOn', 'canvas.group.turnOn', {
    group: 'run',
    when: () => canvasState.isLive && isGrouped(),
    run: () => turnGroups(true),
  })
  add('groupOff', 'canvas.group.turnOff', {
    group: 'run',
    when: () => canvasState.isLive && isGrouped(),
    run: () => turnGroups(false),
  })
  add('check', 'canvas.check', { when: () => canvasState.document !== undefined, run: () => check() })
  add('fit', 'canvas.fitAll', { group: 'view', keys: ['1'], when: isHere, run: () => canvasState.fit() })
  add('fitPicked', 'canvas.fitPicked', {
    group: 'view',
    keys: ['2'],
    when: isPicked,
    run: () => canvasState.fit(pickedTasks()),
  })
  add('fullSize', 'canvas.fullSize', {
    group: 'view',
    keys: ['0'],
    when: isHere,
    run: () => canvasState.view.zoomTo(1),
  })
  add('zoomIn', 'canvas.zoomIn', {
    group: 'view',
    keys: ['+', '='],
    when: isHere,
    run: () => canvasState.view.zoom(1.2),
  })
  add('zoomOut', 'canvas.zoomOut', {
    group: 'view',
    keys: ['-'],
    when: isHere,
    run: () => canvasState.view.zoom(1 / 1.2),
  })
  add('constants', 'canvas.toggleConstants', {
    group: 'view',
    when: () => canvasState.document !== undefined,
    run: toggleConstants,
  })
}

registerCanvas()
