// What a user can do with supermodules. Each sends one act; the environment decides.
import { act } from '../act/act'
import { announce } from '../state/announce'
import { desk } from '../link/desk.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'
import type { Point } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'
import { note, onGrid, pickedTasks } from '../scene/acts'
import { freeName, groupsIn, isAllOn, membersOf, whole } from '../scene/groups'
import { canvasState } from '../scene/canvasState.svelte'

/** Tasks with those that are handled as one with them, those that no longer stand here left out. */
export const wholeOf = (...tasks: string[]): string[] =>
  whole(canvasState.document, tasks).filter((name) => canvasState.document?.tasks?.[name])
export const pickedGroups = (): string[] => groupsIn(canvasState.document, pickedTasks())

/** Pick these tasks as one; the keyboard is on `focus` then. */
export function selectAs(tasks: string[], focus: string): void {
  pick(...tasks)
  canvasState.focus = focus
  const [kind, name] = focus.split(':') as [string, string]
  note(kind === 'group' ? 'select_group' : 'select_icon', name)
}

export const selectGroup = (group: string): void => selectAs(membersOf(canvasState.document, group), `group:${group}`)

/** Add these tasks to what is picked, or take them out where all of them are in it. */
export function selectAlsoAll(tasks: string[], focus: string): void {
  const isIn = tasks.every((task) => canvas.picked.has(task))
  for (const task of tasks)
    if (isIn) canvas.picked.delete(task)
    else canvas.picked.add(task)
  canvasState.focus = focus
}

export function turnGroup(group: string, isOn: boolean, at?: Point): void {
  void act({ t: 'TurnGroup', doc: canvas.doc, name: group, is_on: isOn }, at)
}

export const toggleGroup = (group: string, at?: Point): void =>
  turnGroup(group, !isAllOn(canvasState.document, group), at)

/** Ask for name and order, beside the upper left corner of what is to be one, or is it already. */
export function askForName(tasks = pickedTasks(), name = ''): void {
  const bounds = canvasState.scene.bounds(tasks)
  if (!bounds) return
  const [x, y] = canvasState.view.toClient(bounds.x, bounds.y)
  canvasState.opened = { kind: 'group', at: { x, y }, tasks, name: name || proposedName() }
}

const proposedName = (): string =>
  freeName(t('canvas.group.word'), [
    ...Object.keys(canvasState.document?.groups ?? {}),
    ...Object.keys(canvasState.document?.tasks ?? {}),
    ...Object.values(desk.tree.files).map(({ name }) => name),
  ])

export async function ungroup(groups = pickedGroups()): Promise<void> {
  for (const name of groups)
    if ((await act({ t: 'Ungroup', doc: canvas.doc, name })) !== undefined)
      announce(t('canvas.group.expanded', { name }))
}

/** Ask for another name or order of what is one already. */
export const askForChange = (group: string): void => askForName(membersOf(canvasState.document, group), group)

export const openSaving = (group: string): void => openDialog('saveGroup', { group })

/** Where a pointer is, else in the middle of what is seen: there its upper left corner will be. */
export function openInsert(at = canvasState.pointer): void {
  const [x, y] = at ? canvasState.view.toScene(at.x, at.y) : [canvasState.view.centre.x, canvasState.view.centre.y]
  openDialog('insert', { x: String(onGrid(x)), y: String(onGrid(y)) })
}

/** Place a configuration as a supermodule, and pick it; false where it was refused. */
export async function insert(path: string, x: number, y: number): Promise<boolean> {
  const before = new Set(Object.keys(canvasState.document?.groups ?? {}))
  if ((await act({ t: 'Insert', doc: canvas.doc, path, x, y })) === undefined) return false
  canvasState.begin()
  const name = Object.keys(canvasState.document?.groups ?? {}).find((group) => !before.has(group))
  if (name) {
    selectGroup(name)
    announce(t('canvas.placed', { name }))
  }
  return true
}
