// The commands of the page as a whole: files, undo, the runtime, views.
import { flushSync } from 'svelte'
import { act } from '../act/act'
import { announce } from '../state/announce'
import { command } from '../state/commands'
import { desk } from '../link/desk.svelte'
import { stoppedIn } from '../link/stations'
import { closeLast, isSomethingOpen } from '../state/layers'
import { canvas } from '../state/canvas.svelte'
import { closeDialog, dialogs, openDialog, type DialogName } from '../state/dialogs.svelte'
import { look, THEMES } from '../state/look.svelte'
import { goTo, shownDocument, shownId, shownOne, step, toRedo, toUndo } from '../act/documents.svelte'
import { openBlank, save } from '../act/opening'
import { checkMemory, saveReadings } from '../monitor/memory'
import { allowMotion, stopEverything } from '../shell/stopping'
import { startPuzzles, startTutorial } from '../help/tutorial.svelte'
import { t } from '../texts/index.svelte'

const isOpen = (): boolean => shownOne() !== undefined
const isUpper = (): boolean => look.level === 'applications'
const hasDocument = (): boolean => shownDocument() !== undefined
const isConnected = (): boolean => ['live', 'lost'].includes(shownDocument()?.connection ?? '')
const chosenTask = (): string =>
  canvas.picked.size === 1 ? [...canvas.picked][0]! : canvas.picked.size ? '' : canvas.libraryTask

/** Open a panel, or close it where it is the one that is open. */
function turn(name: DialogName, data: Record<string, string> = {}): void {
  if (dialogs.current.name === name && (dialogs.current.data.what ?? '') === (data.what ?? '')) closeDialog()
  else openDialog(name, data)
}

function switchLevel(): void {
  goTo(isUpper() ? 'tasks' : 'applications')
  announce(t(isUpper() ? 'levels.nowApplications' : 'levels.nowTasks'))
}

command({ id: 'file.new', group: 'file', level: 'tasks', title: () => t('file.new'), keys: ['Alt+N'], run: openBlank })
command({
  id: 'file.newApplication',
  group: 'file',
  level: 'applications',
  title: () => t('file.newApplication'),
  keys: ['Alt+N'],
  run: () => turn('newApplication'),
})
command({
  id: 'file.open',
  group: 'file',
  title: () => t('file.open'),
  keys: ['Ctrl+O'],
  run: () => turn('open'),
  whileTyping: true,
})
command({
  id: 'file.save',
  group: 'file',
  title: () => t('file.save'),
  keys: ['Ctrl+S'],
  when: isOpen,
  run: save,
  whileTyping: true,
})
command({
  id: 'file.saveAs',
  group: 'file',
  title: () => t('file.saveAs'),
  keys: ['Ctrl+Shift+S'],
  when: isOpen,
  run: () => turn('saveAs'),
  whileTyping: true,
})
command({ id: 'file.bringBack', group: 'file', title: () => t('own.bringBack'), run: () => turn('bringBack') })
command({
  id: 'file.close',
  group: 'file',
  title: () => t(isUpper() ? 'file.closeApplication' : 'file.close'),
  keys: ['Alt+W'],
  when: isOpen,
  run: () => act({ t: 'Close', doc: shownId() }, { x: 160, y: 40 }),
})
command({
  id: 'file.next',
  group: 'file',
  title: () => t(isUpper() ? 'file.nextApplication' : 'file.next'),
  keys: ['Alt+PageDown'],
  run: () => step(1),
})
command({
  id: 'file.previous',
  group: 'file',
  title: () => t(isUpper() ? 'file.previousApplication' : 'file.previous'),
  keys: ['Alt+PageUp'],
  run: () => step(-1),
})
command({
  id: 'runtime.whatIf',
  group: 'run',
  title: () => t('whatIf.run'),
  keys: ['Alt+Q'],
  when: () => desk.live.runtime.state === 'linked',
  run: () => turn('whatIf'),
  whileTyping: true,
})
command({
  id: 'file.library',
  group: 'library',
  level: 'tasks',
  title: () => t('file.library'),
  run: () => turn('open', { what: 'library' }),
})
command({ id: 'library.remote', group: 'file', title: () => t('remote.menu'), run: () => turn('remote') })
command({
  id: 'library.newModule',
  group: 'library',
  level: 'tasks',
  title: () => t('newModule.menu'),
  keys: ['Alt+M'],
  run: () => turn('newModule'),
})

command({
  id: 'edit.undo',
  group: 'edit',
  title: () => t('edit.undo'),
  keys: ['Ctrl+Z'],
  when: () => !!toUndo(),
  run: () => act({ t: 'Undo', doc: shownId() }),
})
command({
  id: 'edit.redo',
  group: 'edit',
  title: () => t('edit.redo'),
  keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
  when: () => !!toRedo(),
  run: () => act({ t: 'Redo', doc: shownId() }),
})

const findField = (): HTMLInputElement | null => document.querySelector('.library [role=searchbox]')
function find(): void {
  flushSync(() => {
    look.column = 'left'
    look.folded.left = false
  })
  findField()?.focus()
  findField()?.select()
}
const isOnCanvas = (): boolean => document.activeElement?.closest('.canvas') != null
command({
  id: 'library.find',
  group: 'library',
  level: 'tasks',
  title: () => t('library.find'),
  keys: ['Ctrl+F'],
  run: find,
  whileTyping: true,
})
command({
  id: 'library.findHere',
  group: 'library',
  level: 'tasks',
  title: () => t('library.findHere'),
  keys: ['/'],
  when: () => !isOnCanvas(),
  run: find,
})
command({
  id: 'task.source',
  group: 'library',
  level: 'tasks',
  title: () => t('task.source'),
  keys: ['Alt+S'],
  when: () => chosenTask() !== '',
  run: () => openDialog('source', { task: chosenTask(), kind: 'code' }),
})
command({
  id: 'task.rmod',
  group: 'library',
  level: 'tasks',
  title: () => t('task.rmod'),
  keys: ['Alt+R'],
  when: () => chosenTask() !== '',
  run: () => openDialog('source', { task: chosenTask(), kind: 'rmod' }),
})

command({
  id: 'run.stop',
  group: 'run',
  title: () => t('stop.everything'),
  keys: ['Ctrl+.', 'Pause'],
  run: stopEverything,
  whileTyping: true,
})
command({
  id: 'run.reset',
  group: 'run',
  title: () => t('stop.reset'),
  when: () => stoppedIn(desk.tree).length > 0,
  run: allowMotion,
})
command({
  id: 'run.connect',
  group: 'run',
  level: 'tasks',
  title: () => t('runtime.connect'),
  keys: ['Alt+C'],
  when: () => hasDocument() && !isConnected(),
  run: () => openDialog('connect'),
})
command({
  id: 'run.disconnect',
  group: 'run',
  level: 'tasks',
  title: () => t('connect.leave'),
  when: isConnected,
  run: () => act({ t: 'Disconnect', doc: canvas.doc }),
})
command({
  id: 'run.checkMemory',
  group: 'run',
  level: 'tasks',
  title: () => t('memory.check'),
  when: isConnected,
  run: () => checkMemory(canvas.doc),
})
command({
  id: 'run.saveReadings',
  group: 'run',
  level: 'tasks',
  title: () => t('memory.save'),
  when: isConnected,
  run: () => saveReadings(canvas.doc),
})
const keptNames = (): string[] => Object.keys(shownDocument()?.kept ?? {}).sort()
command({
  id: 'run.switchKept',
  group: 'run',
  level: 'tasks',
  title: () => t('kept.next'),
  when: () => keptNames().length > 0,
  run: () => {
    const shown = shownDocument()?.name ?? ''
    const name = keptNames().find((kept) => kept > shown) ?? keptNames()[0]
    if (name) return act({ t: 'SwitchTo', doc: canvas.doc, name })
  },
})
command({
  id: 'run.take',
  group: 'run',
  level: 'tasks',
  title: () => t('holder.takeIt'),
  when: () => isConnected() && !shownDocument()?.is_held_here,
  run: () => act({ t: 'Take', doc: canvas.doc }),
})
command({
  id: 'run.release',
  group: 'run',
  level: 'tasks',
  title: () => t('holder.release'),
  when: () => isConnected() && shownDocument()?.is_held_here === true,
  run: () => act({ t: 'Release', doc: canvas.doc }),
})

command({
  id: 'view.closePanel',
  group: 'view',
  title: () => t('shell.closePanel'),
  keys: ['Escape'],
  when: isSomethingOpen,
  run: closeLast,
  inDialogs: true,
})
command({
  id: 'view.level',
  group: 'view',
  title: () => t(isUpper() ? 'levels.goTasks' : 'levels.goApplications'),
  keys: ['Ctrl+Shift+L'],
  when: () => !look.isUpperOnly,
  run: switchLevel,
  whileTyping: true,
})
command({
  id: 'view.showLower',
  group: 'view',
  title: () => t(look.isUpperOnly ? 'levels.showLower' : 'levels.hideLower'),
  run: () => act({ t: 'Prefer', values: { shows_lower: look.isUpperOnly } }),
})
command({
  id: 'view.palette',
  group: 'help',
  title: () => t('palette.title'),
  keys: ['Ctrl+K'],
  run: () => (dialogs.isPaletteOpen = !dialogs.isPaletteOpen),
  whileTyping: true,
})
command({
  id: 'view.help',
  group: 'help',
  title: () => t('help.title'),
  keys: ['?', 'F1'],
  run: () => turn('help'),
  inDialogs: true,
})
command({ id: 'view.tutorial', group: 'help', title: () => t('tutorial.title'), run: startTutorial })
command({ id: 'view.puzzles', group: 'help', title: () => t('puzzle.title'), run: startPuzzles })
command({
  id: 'view.preferences',
  group: 'view',
  title: () => t('prefer.title'),
  keys: ['Ctrl+,'],
  run: () => turn('preferences'),
  whileTyping: true,
})
command({ id: 'view.buttons', group: 'view', title: () => t('buttons.title'), run: () => turn('buttons') })

for (const theme of THEMES)
  command({
    id: `view.theme.${theme}`,
    group: 'view',
    title: () => t('theme.choose', { look: t(`theme.${theme}`) }),
    run: () => {
      look.theme = theme
      announce(t(`theme.${theme}`))
    },
  })
command({
  id: 'view.language',
  group: 'view',
  title: () => t('language.next'),
  also: () => t('language.also'),
  run: () => (look.language = look.language === 'en' ? 'es' : 'en'),
})
command({
  id: 'view.sounds',
  group: 'view',
  title: () => (look.sounds ? t('sounds.off') : t('sounds.on')),
  run: () => (look.sounds = !look.sounds),
})
