// Commands of runs that are recorded or kept.
import { announce } from '../state/announce'
import { command } from '../state/commands'
import { desk } from '../link/desk.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { workspace } from '../state/workspace.svelte'
import { options } from '../state/options.svelte'
import { openRecording } from '../recording/acts'
import { isHandHeld, isRecorded, recordByHand } from '../scene/recordByHand'
import { isReviewing } from '../recording/review.svelte'
import { t } from '../texts/index.svelte'

const last = (): string => (desk.live.run?.state === 'over' ? (desk.live.run.recording ?? '') : '')

function turn(): void {
  options.records = !options.records
  announce(t(options.records ? 'recording.recordOn' : 'recording.recordOff'))
}

command({
  id: 'application.record',
  group: 'application',
  level: 'applications',
  title: () => (options.records ? `${t('recording.record')} ✓` : t('recording.record')),
  keys: ['Alt+R'],
  run: turn,
})
command({
  id: 'configuration.record',
  group: 'run',
  level: 'tasks',
  title: () => t(isRecorded() ? 'recording.endByHand' : 'recording.byHand'),
  keys: ['Alt+R'],
  when: () => isHandHeld() && !isReviewing(),
  run: () => void recordByHand(),
})
command({
  id: 'application.look',
  group: 'application',
  title: () => t('recording.look'),
  when: () => last() !== '' && !isReviewing(),
  run: () => openRecording(last()),
})
command({
  id: 'application.keep',
  group: 'application',
  level: 'applications',
  title: () => t('recording.keep'),
  keys: ['Alt+Shift+K'],
  when: () => workspace.app !== '',
  run: () => openDialog('keep', { doc: workspace.app }),
})
