// Which component each dialog is; what is opened anew for something else begins anew.
import type { Component } from 'svelte'
import IconPanel from './dictionary/IconPanel.svelte'
import NewApplicationPanel from './dictionary/NewApplicationPanel.svelte'
import TargetPanel from './dictionary/TargetPanel.svelte'
import OpenPanel from './files/OpenPanel.svelte'
import SaveAsPanel from './files/SaveAsPanel.svelte'
import InsertPanel from './group/InsertPanel.svelte'
import SaveGroupPanel from './group/SaveGroupPanel.svelte'
import WhatIfPanel from './foresight/WhatIfPanel.svelte'
import HelpSheet from './help/HelpSheet.svelte'
import BookingsPanel from './holding/BookingsPanel.svelte'
import HoldingPanel from './holding/HoldingPanel.svelte'
import RemoteLibrariesPanel from './library/RemoteLibrariesPanel.svelte'
import JobPanel from './picture/JobPanel.svelte'
import ScopePanel from './monitor/ScopePanel.svelte'
import RedirectPanel from './redirect/RedirectPanel.svelte'
import RecordingsPanel from './review/RecordingsPanel.svelte'
import KeepPanel from './run/KeepPanel.svelte'
import ButtonsPanel from './shell/ButtonsPanel.svelte'
import UnitPanel from './monitor/UnitPanel.svelte'
import ConnectPanel from './shell/ConnectPanel.svelte'
import PreferencesPanel from './shell/PreferencesPanel.svelte'
import BringBackPanel from './task/BringBackPanel.svelte'
import NewModulePanel from './task/NewModulePanel.svelte'
import OwnPanel from './task/OwnPanel.svelte'
import SetsPanel from './task/SetsPanel.svelte'
import SourcePanel from './task/SourcePanel.svelte'
import type { DialogName } from './state/dialogs.svelte'

export const DIALOGS: Partial<Record<DialogName, Component>> = {
  bookings: BookingsPanel,
  bringBack: BringBackPanel,
  buttons: ButtonsPanel,
  connect: ConnectPanel,
  help: HelpSheet,
  holding: HoldingPanel,
  icon: IconPanel,
  insert: InsertPanel,
  job: JobPanel,
  keep: KeepPanel,
  newApplication: NewApplicationPanel,
  newModule: NewModulePanel,
  open: OpenPanel,
  own: OwnPanel,
  preferences: PreferencesPanel,
  recordings: RecordingsPanel,
  redirect: RedirectPanel,
  remote: RemoteLibrariesPanel,
  saveAs: SaveAsPanel,
  saveGroup: SaveGroupPanel,
  scope: ScopePanel,
  sets: SetsPanel,
  source: SourcePanel,
  target: TargetPanel,
  unit: UnitPanel,
  whatIf: WhatIfPanel,
}

/** Those that begin anew each time they are opened, also while they are open. */
export const KEYED: ReadonlySet<string> = new Set(['bringBack', 'icon', 'keep', 'own', 'recordings', 'redirect'])
