// What a user can do with supermodules. Each sends one act; the environment decides.
import { act } from '../act/act'
import { announce } from '../state/announce'
import { desk } from '../link/desk.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'
import type { Point } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'
import { note, onGrid, pickedTasks } from '../scene/deeds'
import { freeName, groupsIn, isAllOn, membersOf, whole } from '../scene/groups'
import { stage } from '../scene/stage.svelte'

/** Tasks with those that are handled as one with them, those that no longer stand here left out. */
export const wholeOf = (...tasks: string[]): string[] => whole(stage.document, tasks).filter((name) => stage.document?.tasks?.[name])
export const pickedGroups = (): string[] => groupsIn(stage.document, pickedTasks())

/** Pick these tasks as one; the keyboard is on `focus` then. */
export function selectAs(tasks: string[], focus: string): void {
  pick(...tasks)
  stage.focus = focus
  note('select', ...(focus.split(':') as [string, string]))
}

export const selectGroup = (group: string): void => selectAs(membersOf(stage.document, group), `group:${group}`)

/** Add these tasks to what is picked, or take them out where all of them are in it. */
export function selectAlsoAll(tasks: string[], focus: string): void {
  const isIn = tasks.every((one) => canvas.picked.has(one))
  for (const one of tasks) if (isIn) canvas.picked.delete(one)
  else canvas.picked.add(one)
  stage.focus = focus
}

export function turnGroup(group: string, isOn: boolean, at?: Point): void {
  void act({ t: 'TurnGroup', doc: canvas.doc, name: group, is_on: isOn }, at)
}

export const toggleGroup = (group: string, at?: Point): void => turnGroup(group, !isAllOn(stage.document, group), at)

/** Ask for name and order, beside the upper left corner of what is to be one, or is it already. */
export function askForName(tasks = pickedTasks(), name = ''): void {
  const bounds = stage.scene.bounds(tasks)
  if (!bounds) return
  const [x, y] = stage.view.toClient(bounds.x, bounds.y)
  stage.opened = { kind: 'group', at: { x, y }, tasks, name: name || proposedName() }
}

const proposedName = (): string =>
  freeName(t('canvas.group.word'), [
    ...Object.keys(stage.document?.groups ?? {}), ...Object.keys(stage.document?.tasks ?? {}), ...Object.values(desk.tree.files).map(({ name }) => name),
  ])

export async function ungroup(groups = pickedGroups()): Promise<void> {
  for (const name of groups)
    if ((await act({ t: 'Ungroup', doc: canvas.doc, name })) !== undefined) announce(t('canvas.group.expanded', { name }))
}

/** Ask for another name or order of what is one already. */
export const askForChange = (group: string): void => askForName(membersOf(stage.document, group), group)

export const openSaving = (group: string): void => openDialog('saveGroup', { group })

/** Where a pointer is, else in the middle of what is seen: there its upper left corner will be. */
export function openInsert(at = stage.pointer): void {
  const [x, y] = at ? stage.view.toScene(at.x, at.y) : [stage.view.centre.x, stage.view.centre.y]
  openDialog('insert', { x: String(onGrid(x)), y: String(onGrid(y)) })
}

/** Place a configuration as a supermodule, and pick it; false where it was refused. */
export async function insert(path: string, x: number, y: number): Promise<boolean> {
  const before = new Set(Object.keys(stage.document?.groups ?? {}))
  if ((await act({ t: 'Insert', doc: canvas.doc, path, x, y })) === undefined) return false
  stage.begin()
  const name = Object.keys(stage.document?.groups ?? {}).find((one) => !before.has(one))
  if (name) {
    selectGroup(name)
    announce(t('canvas.placed', { name }))
  }
  return true
}
