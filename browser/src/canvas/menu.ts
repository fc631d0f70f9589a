// The menus that open beside the pointer: today's habit beside the keys and buttons of the dissertation.
import type { Item } from '../widgets/Menu.svelte'
import { canvas } from '../state/canvas.svelte'
import { desk } from '../link/desk.svelte'
import type { Point } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'
import {
  align,
  check,
  clear,
  copy,
  cut,
  flip,
  openSheet,
  openSource,
  paste,
  pickedTasks,
  placeAt,
  remove,
  arrange,
  selectAll,
  turnAll,
  toggleConstants,
  toggleLines,
  togglePin,
  turn,
  type Edge,
} from '../scene/acts'
import { askForChange, askForName, openInsert, openSaving, pickedGroups, turnGroup, ungroup } from '../group/grouping'
import { isAllOn, summary } from '../scene/groups'
import { makeTarget } from '../scene/variableTarget'
import { canvasState, type Opened } from '../scene/canvasState.svelte'

export function menuOf(opened: Opened): { label: string; items: Item[] } | undefined {
  if (opened.kind !== 'menu') return undefined
  const { over, at } = opened
  if (over.kind === 'task') return { label: over.name, items: taskItems(over.name, at) }
  if (over.kind === 'locus') return { label: over.name, items: locusItems(over.name, at) }
  if (over.kind === 'group') return { label: over.name, items: tabItems(over.name, at) }
  return { label: t('canvas.menu'), items: groundItems(at) }
}

function taskItems(name: string, at: Point): Item[] {
  const tasks = pickedTasks()
  const placed = canvasState.document?.tasks?.[name]
  const task = desk.task(name, canvas.doc)
  return [
    ...(canvasState.isLive ? liveItems(tasks, name, at) : []),
    { label: t('canvas.parameters'), keys: 'Enter', run: () => openSheet(name), begins: canvasState.isLive },
    {
      label: t('canvas.source'),
      run: () => openSource(name, 'code'),
      isOff: !task?.code,
      note: task?.code ? undefined : t('canvas.noSource'),
    },
    { label: t('canvas.rmod'), run: () => openSource(name, 'rmod'), isOff: placed?.is_missing === true },
    { label: t('canvas.cut'), keys: 'Delete', run: () => cut(), begins: true },
    { label: t('canvas.copy'), keys: 'Ctrl+C', run: () => copy() },
    { label: t('canvas.flip'), keys: 'R', run: () => flip() },
    { label: t('canvas.delete'), run: () => remove() },
    ...(tasks.length > 1 ? groupItems(tasks) : []),
    ...(tasks.length > 1 ? alignItems(tasks.length) : []),
  ]
}

/** On the tab of a supermodule: what is done to all its tasks. */
function tabItems(group: string, at: Point): Item[] {
  const tasks = pickedTasks()
  return [
    ...(canvasState.isLive ? turnItems(group, at) : []),
    { label: t('canvas.group.change'), run: () => askForChange(group), begins: canvasState.isLive },
    { label: t('canvas.group.expand'), keys: 'Ctrl+Shift+G', run: () => ungroup([group]) },
    { label: t('canvas.group.save'), run: () => openSaving(group) },
    { label: t('canvas.cut'), keys: 'Delete', run: () => cut(), begins: true },
    { label: t('canvas.copy'), keys: 'Ctrl+C', run: () => copy() },
    { label: t('canvas.flip'), keys: 'R', run: () => flip() },
    { label: t('canvas.delete'), run: () => remove() },
    ...(tasks.length > 1 ? alignItems(tasks.length) : []),
  ]
}

function turnItems(group: string, at: Point): Item[] {
  const { document } = canvasState
  return [
    {
      label: t('canvas.turnOn'),
      keys: 'Shift+Enter',
      run: () => turnGroup(group, true, at),
      isOff: isAllOn(document, group),
    },
    {
      label: t('canvas.turnOff'),
      run: () => turnGroup(group, false, at),
      isOff: summary(document, group).look === 'OFF',
    },
  ]
}

/** Several tasks become one; what is one already may be taken apart, or saved. */
function groupItems(tasks: string[]): Item[] {
  const groups = pickedGroups()
  const isOne = groups.length === 1 && canvasState.document?.groups?.[groups[0]!]?.tasks.length === tasks.length
  const make: Item = { label: t('canvas.group.makeIt'), keys: 'Ctrl+G', run: () => askForName(tasks), begins: true }
  if (!groups.length) return [make]
  return [
    ...(isOne ? [] : [make]),
    { label: t('canvas.group.expand'), keys: 'Ctrl+Shift+G', run: () => ungroup(groups), begins: isOne },
    ...groups.map((group) => ({ label: t('canvas.group.saveIt', { name: group }), run: () => openSaving(group) })),
  ]
}

function liveItems(tasks: string[], name: string, at: Point): Item[] {
  const states = tasks.map((task) => canvasState.document?.tasks?.[task]?.state)
  if (canvasState.document?.tasks?.[name]?.state === 'ERROR')
    return [
      { label: t('canvas.clear'), run: () => clear(name, true, at) },
      { label: t('canvas.clearOnly'), run: () => clear(name, false, at) },
    ]
  return [
    {
      label: t('canvas.turnOn'),
      keys: 'Shift+Enter',
      run: () => turn(tasks, true, at),
      isOff: states.every((state) => state === 'ON'),
    },
    { label: t('canvas.turnOff'), run: () => turn(tasks, false, at), isOff: states.every((state) => state === 'OFF') },
  ]
}

const EDGES: readonly Edge[] = ['left', 'right', 'top', 'bottom', 'columns', 'rows']

function alignItems(count: number): Item[] {
  const edges = count > 2 ? EDGES : EDGES.slice(0, 4)
  return edges.map((edge, k) => ({ label: t(`canvas.align.${edge}`), run: () => align(edge), begins: k === 0 }))
}

function locusItems(svar: string, at: Point): Item[] {
  const locus = canvasState.document?.loci?.[svar]
  const isDrawn = canvasState.scene.dots.has(svar) && locus?.is_shown !== false
  return [
    { label: t('canvas.information'), keys: 'Enter', run: () => (canvasState.opened = { kind: 'locus', at, svar }) },
    {
      label: t(canvas.pinned.includes(svar) ? 'canvas.unpinIt' : 'canvas.pinIt'),
      run: () => togglePin(svar),
      isOff: !canvasState.scene.dots.has(svar),
    },
    {
      label: t('canvas.plotIt'),
      run: () => (canvas.plots = [...new Set([...canvas.plots, svar])]),
      isOff: canvas.plots.includes(svar),
    },
    { label: t(isDrawn ? 'canvas.hideLines' : 'canvas.showLines'), keys: 'Shift+Enter', run: () => toggleLines(svar) },
    {
      label: t('target.of'),
      run: () => makeTarget(svar, at),
      isOff: !canvasState.hasValues,
      note: canvasState.hasValues ? undefined : t('canvas.noValue'),
      begins: true,
    },
  ]
}

function groundItems(at: Point): Item[] {
  return [
    ...(canvas.libraryTask
      ? [
          {
            label: t('canvas.placeIt', { name: canvas.libraryTask }),
            run: () => placeAt(canvas.libraryTask, at, false),
          },
        ]
      : []),
    { label: t('canvas.addTask'), keys: '/', run: () => (canvasState.opened = { kind: 'quick', at }) },
    {
      label: t('canvas.paste'),
      keys: 'Ctrl+V',
      run: () => paste(),
      isOff: !desk.tree.clipboard,
      note: desk.tree.clipboard || undefined,
    },
    { label: t('canvas.group.insert'), run: () => openInsert(at) },
    { label: t('canvas.selectAll'), keys: 'Ctrl+A', run: selectAll },
    { label: t('canvas.fit'), keys: '1', run: () => canvasState.fit(), begins: true },
    { label: t(canvasState.isConstantsShown ? 'canvas.hideConstants' : 'canvas.showConstants'), run: toggleConstants },
    { label: t('canvas.arrange'), run: () => arrange(), begins: true },
    ...(canvasState.isLive
      ? [
          { label: t('canvas.allOn'), run: () => turnAll(true, at), begins: true },
          { label: t('canvas.allOff'), run: () => turnAll(false, at) },
        ]
      : []),
    { label: t('canvas.check'), run: () => check(at), begins: true },
  ]
}
