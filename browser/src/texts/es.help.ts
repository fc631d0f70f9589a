// Spanish: the help sheet, the tutorial and the courses.
import type { enHelp } from './en.help'

export const esHelp: Record<keyof typeof enHelp, string> = {
  'mouse.dictionary': 'Ratón en el diccionario',
  'mouse.workspace': 'Ratón en el espacio de trabajo',
  'mouse.leftIcon': 'izquierdo, en un icono',
  'mouse.doubleIcon': 'doble clic, en un icono',
  'mouse.dragIcon': 'arrastrar un icono; con Ctrl',
  'mouse.shiftLeftJob': 'Mayús + izquierdo, en un trabajo',
  'mouse.shiftLeftApplication': 'Mayús + izquierdo, en una aplicación',
  'mouse.middleAction': 'central, en una acción',
  'mouse.middleTarget': 'central, en un objetivo',
  'mouse.shiftMiddleIcon': 'Mayús + central, en un icono',
  'mouse.restJob': 'detenerse sobre un icono',
  'mouse.d.select': 'Seleccionar; arrastrar al espacio de trabajo',
  'mouse.d.deselect': 'No seleccionar nada',
  'mouse.d.insert': 'Insertarlo donde está el cursor',
  'mouse.d.configuration': 'Abrir su configuración en el nivel inferior',
  'mouse.d.application': 'Abrir la aplicación en una pestaña',
  'mouse.d.types': 'Mostrar su nombre y sus tipos',
  'mouse.d.values': 'Ver y cambiar sus valores',
  'mouse.d.picture': 'Abrir el editor de imágenes',
  'mouse.d.card': 'Mostrar en pequeño lo que hay detrás',
  'mouse.w.select': 'Seleccionar; Ctrl añade a la selección',
  'mouse.w.deselect': 'No seleccionar nada',
  'mouse.w.insert': 'Insertar detrás lo seleccionado en el diccionario; si no, un menú',
  'mouse.w.move': 'Moverlo; copiarlo',
  'help.parts': 'Partes de la ayuda',
  'help.pictures': 'En imágenes',
  'help.words': 'En breve',
  'help.keys': 'Teclas y ratón',
  'help.lower': 'Nivel inferior: tareas',
  'help.upper': 'Nivel superior: aplicaciones',
  'help.everywhere': 'En todas partes',
  'guide.lead':
    'Un programa es una fila de imágenes entre salida y parada. Cada imagen es algo que hace el robot, o dónde lo hace.',
  'guide.choose': 'Elija una imagen',
  'guide.chooseSay': 'Haga clic en ella en el diccionario, a la izquierda. `Ctrl F` la busca por sus palabras.',
  'guide.put': 'Colóquela',
  'guide.putSay':
    'Clic derecho en la imagen a la que debe seguir. O arrástrela, o haga doble clic en ella, o escriba `/` y sus palabras, y luego `Enter`.',
  'guide.fit': 'Los bordes deben encajar',
  'guide.fitSay':
    'Como en un rompecabezas: un borde amarillo pide un vecino amarillo. A un trabajo que mueve hay que decirle adónde: su objetivo va justo detrás.',
  'guide.hole': 'Un hueco guarda el sitio',
  'guide.holeSay':
    'Donde falta una pieza, un hueco muestra los bordes que necesita. Haga clic en él: «Encaja aquí» muestra lo que puede ir. Un programa con huecos no se ejecuta.',
  'guide.change': 'Cámbielo',
  'guide.changeSay':
    '`Supr` quita la imagen seleccionada, `C` copia, `V` pega, arrastrar mueve. `Ctrl Z` lo deshace todo.',
  'guide.run': 'Ejecútelo',
  'guide.runSay':
    'Pulse Ejecutar, a la derecha. Pausa espera tras la acción en curso. Parar, arriba a la derecha o `Ctrl .`, detiene todos los accionamientos al instante.',
  'guideWords.lead':
    'Un programa es una fila de cuadros entre salida y parada. Cada uno es algo que hace el robot, o dónde lo hace.',
  'guideWords.choose': 'Elija qué hacer',
  'guideWords.putSay':
    'Clic derecho en el cuadro al que debe seguir. O arrástrelo, o haga doble clic en él, o escriba `/` y sus palabras, y luego `Enter`.',
  'guideWords.fit': 'Los vecinos deben encajar',
  'guideWords.fitSay':
    'Lo que no encaja se rechaza, y se dice por qué. A un trabajo que mueve hay que decirle adónde: su objetivo va justo detrás.',
  'guideWords.holeSay':
    'Donde falta algo, un hueco guarda el sitio. Haga clic en él: «Encaja aquí» muestra lo que puede ir. Un programa con huecos no se ejecuta.',
  'guideWords.changeSay':
    '`Supr` quita el cuadro seleccionado, `C` copia, `V` pega, arrastrar mueve. `Ctrl Z` lo deshace todo.',
  'guideWords.inside': 'ver de qué está hecho un cuadro',
  'guide.more': 'Y además',
  'guide.breakpoint': 'pausar tras esta acción',
  'guide.together': 'empezar junto con otro flujo',
  'guide.loop': 'repetir desde aquí hasta allí',
  'guide.inside': 'ver de qué está hecha una imagen',
  'guide.shiftClick': 'Mayús + clic',
  'guide.save': 'guardarlo con un nombre',
  'guide.keys': 'esta ayuda, con todas las teclas',
  'tutorial.title': 'Tutorial, 15 minutos',
  'tutorial.begin': 'Tutorial, 15 minutos',
  'tutorial.count': '{done} de {of}',
  'tutorial.done': '(hecho)',
  'tutorial.skipped': '(omitido)',
  'tutorial.next': 'Hecho. A continuación: {what}',
  'tutorial.over':
    'Eso es todo lo que necesita. Ahora construya el suyo, o abra «assemble» y ejecútelo: cuatro cajas, y al final se enciende la lámpara.',
  'tutorial.again': 'Desde el principio',
  'tutorial.skip': 'Saltar esto',
  'tutorial.new': 'Cree una aplicación nueva',
  'tutorial.newHow':
    'Pulse + junto a las pestañas de arriba y elija un flujo. Verá salida, parada y un espacio entre ellas.',
  'tutorial.complete': 'Ponga «abre la mano» detrás de la salida',
  'tutorial.completeHow':
    'Haga clic en su imagen en el diccionario y luego clic derecho en la salida. Arrastrarla hasta allí hace lo mismo.',
  'tutorial.job': 'Ponga «mueve las articulaciones» detrás',
  'tutorial.jobHow': 'Su borde derecho es amarillo: quiere saber adónde. Hasta entonces, un hueco guarda el sitio.',
  'tutorial.fill': 'Llene el hueco con un objetivo amarillo',
  'tutorial.fillHow':
    'Haga clic en el hueco y pulse «Encaja aquí» en el diccionario: solo se muestra lo que encaja. Tome uno que esté sobre una caja.',
  'tutorial.out': 'Quite otra vez el objetivo',
  'tutorial.outHow': 'Haga clic en él y pulse `Supr`. El hueco ha vuelto.',
  'tutorial.back': 'Deshágalo',
  'tutorial.backHow': '`Ctrl Z`. Todo se puede deshacer, y `Ctrl Mayús Z` lo rehace.',
  'tutorial.run': 'Ejecútelo',
  'tutorial.runHow':
    'Pulse Ejecutar a la derecha. La acción en curso lleva un contorno; lo hecho, una marca. Nada puede romperse: el brazo es simulado.',
  'tutorial.pause': 'Páuselo',
  'tutorial.pauseHow':
    'Pulse Pausa mientras está en marcha: espera tras la acción actual. Si acabó demasiado pronto, ejecútelo otra vez.',
  'tutorial.goOn': 'Déjelo continuar',
  'tutorial.goOnHow': 'Pulse Continuar.',
  'tutorial.end': 'Vea cómo termina',
  'tutorial.endHow': 'A la derecha se dice cómo fue y cuánto tardó.',
  'tutorial.save': 'Guárdelo con un nombre',
  'tutorial.saveHow':
    '`Ctrl S`. Entonces es un archivo y, si lo desea, una imagen para otros programas: «Como icono…».',
  'tutorialWords.completeHow':
    'Haga clic en él en el diccionario y luego clic derecho en la salida. Arrastrarlo hasta allí hace lo mismo.',
  'tutorialWords.jobHow': 'Quiere saber adónde. Hasta entonces, un hueco guarda el sitio.',
  'tutorialWords.fill': 'Llene el hueco con un objetivo',
  'tutorialWords.saveHow':
    '`Ctrl S`. Entonces es un archivo y, si lo desea, un cuadro para otros programas: «Como icono…».',
  'tutorial.course': 'Curso',
  'tutorial.course.first': 'Primeros pasos',
  'tutorial.course.loops': 'Bucles',
  'tutorial.course.branches': 'Bifurcaciones',
  'tutorial.course.meetings': 'Flujos que se encuentran',
  'tutorial.course.arms': 'Dos brazos',
  'tutorial.course.nesting': 'Programas en programas',
  'tutorial.courseOver': 'Este curso ha terminado. Arriba hay otro.',
  'tutorial.open': 'Abrir «{name}»',
  'tutorial.changed':
    '«{name}» se ha cambiado aquí, así que no cuenta. Deshágalo (`Ctrl Z`), o ciérrelo sin guardar y ábralo de nuevo.',
  'tutorial.loopSee': 'Vea un bucle que funciona',
  'tutorial.loopSeeHow': 'Ábralo y pulse Ejecutar. Lea las frases de abajo: ¿adónde vuelve, y qué lo decide?',
  'tutorial.twoActions': 'Haga un programa de dos acciones',
  'tutorial.twoActionsHow':
    'Una aplicación nueva de un flujo, por ejemplo «abre la mano» y «cierra la mano». No debe quedar ningún hueco.',
  'tutorial.loop': 'Repítalas',
  'tutorial.loopHow':
    'Seleccione las dos (Mayús + flechas), pulse con el botón derecho y elija «Repetir … veces»: dos.',
  'tutorial.loopRun': 'Ejecútelo y vea cómo vuelve',
  'tutorial.loopRunHow':
    'Pulse Ejecutar. Cuenta cuando la ejecución se completa y una acción del bucle se hizo al menos dos veces.',
  'tutorial.loopWithin': 'Averigüe: ¿cuántas veces se hace lo que está en un bucle dentro de otro?',
  'tutorial.loopWithinHow':
    'Seleccione el bucle entero y repítalo otra vez, tres veces; delante viene un «no hagas nada», pues una acción lleva la marca de un solo bucle. Diga antes un número; luego ejecútelo y mire las cuentas en los iconos. Cuenta cuando una acción del bucle interior se hizo cuatro veces o más.',
  'tutorial.branchSee': 'Vea una bifurcación que funciona',
  'tutorial.branchSeeHow':
    'Ábrala y pulse Ejecutar. ¿Qué flujo toma, y qué tendría que ocurrir para que tomase el otro?',
  'tutorial.branch': 'Ponga una bifurcación en un programa suyo',
  'tutorial.branchHow': 'Pulse con el botón derecho donde deba estar y elija «Insertar una bifurcación…».',
  'tutorial.branchFlows': 'Dele una condición, y a cada uno de sus flujos una acción',
  'tutorial.branchFlowsHow':
    'Por ejemplo `LAMP == 1` para el primer flujo. Lo más rápido es lo que no necesita objetivo, como «abre la mano».',
  'tutorial.branchRun': 'Ejecútelo y vea qué flujo toma',
  'tutorial.branchRunHow': 'Cuenta cuando la ejecución se completa y se hizo un flujo de la bifurcación y el otro no.',
  'tutorial.branchMiddle': 'Averigüe: haga que una bifurcación de tres flujos tome el del medio',
  'tutorial.branchMiddleHow':
    'Inserte otra bifurcación, de tres flujos con dos condiciones. Decide la primera condición que se cumple; pruebe `GRIP_MEZ[0] < 0.07` detrás de «cierra la mano», y cámbiela hasta que se ejecute el del medio.',
  'tutorial.meetSee': 'Vea dos flujos que se encuentran',
  'tutorial.meetSeeHow':
    'Ábralo y pulse Ejecutar. Dos brazos se apartan y saludan en el mismo instante, tarde lo que tarde cada uno.',
  'tutorial.twoFlows': 'Haga una aplicación de dos flujos en paralelo',
  'tutorial.twoFlowsHow':
    'Una aplicación nueva, dos flujos, paralela; o «Añadir un flujo» debajo del primero. Junto al nombre debe decir «paralela».',
  'tutorial.tags': 'Haga que se esperen',
  'tutorial.tagsHow':
    'Dé a cada flujo acciones de su propio brazo. Pulse con el botón derecho una acción de cada uno, elija «Sincronizar…» y dé a las dos la misma marca.',
  'tutorial.meet': 'Ejecútelo y vea cómo se encuentran',
  'tutorial.meetHow':
    'Cuenta cuando la ejecución se completa y los flujos han empezado juntos en esa marca: una línea que los cruza en la línea de tiempo.',
  'tutorial.meetTwice': 'Averigüe: haga que se encuentren dos veces',
  'tutorial.meetTwiceHow':
    'Una segunda marca, más adelante en los dos. ¿Qué pasa si en uno de los flujos las dos marcas están en el orden contrario? Pruébelo: la página lo dice antes de que nada se mueva. Cuenta cuando una ejecución completa se encontró en dos marcas.',
  'tutorial.armsSee': 'Vea dos brazos trabajando',
  'tutorial.armsSeeHow': 'Ábralo y pulse Ejecutar. Cada flujo mueve un brazo propio, y ninguno espera al otro.',
  'tutorial.armsFlows': 'Haga un programa para los dos brazos',
  'tutorial.armsFlowsHow':
    'Una aplicación nueva de dos flujos, paralela. En uno, «mueve las articulaciones» y un objetivo; en el otro, «mueve las articulaciones del brazo derecho» y un objetivo, como «a la izquierda, lejos de la mesa». No debe quedar ningún hueco.',
  'tutorial.armsRun': 'Ejecútelo y vea cómo se mueven los dos',
  'tutorial.armsRunHow': 'Cuenta cuando la ejecución se completa y los dos brazos han hecho algo.',
  'tutorial.armsWait': 'Averigüe: haga que un brazo empiece solo cuando el otro haya terminado un movimiento',
  'tutorial.armsWaitHow':
    '¿Dónde deben estar las dos marcas? Ponga una en la primera acción del brazo que espera. Cuenta cuando la ejecución se completa y allí siguieron juntos.',
  'tutorial.nestSee': 'Vea un programa hecho de programas',
  'tutorial.nestSeeHow':
    'Ábralo y pulse Ejecutar. Una sola imagen va hasta allí y saluda: es un programa entero, y toma un objetivo.',
  'tutorial.nestInside': 'Mire dentro de uno',
  'tutorial.nestInsideHow':
    'Mantenga Mayús y haga clic en «ve y saluda con los dedos»: al lado se abre de qué está hecho. Su hueco es lo que llena el objetivo.',
  'tutorial.nestUse': 'Úselo en un programa suyo',
  'tutorial.nestUseHow': 'Una aplicación nueva: ponga en ella «ve y saluda con los dedos», y detrás un objetivo.',
  'tutorial.nestRun': 'Ejecútelo también',
  'tutorial.nestRunHow': 'Cuenta cuando la ejecución se completa. Mayús + clic mira dentro mientras se ejecuta.',
  'tutorial.nestOwn': 'Averigüe: haga una imagen de un programa suyo, y úsela',
  'tutorial.nestOwnHow':
    'Guarde un programa y elija «Como icono…» debajo de su nombre. Ponga la imagen nueva en otro programa y ejecútelo. ¿Qué debe dejar abierto para tomar un objetivo?',
  'tutorial.course.seeking': 'Cómo se busca un fallo',
  'tutorial.seekSee': 'Vea un programa que funciona',
  'tutorial.seekSeeHow':
    'Ábralo y pulse Ejecutar: la mano toma la caja con el triángulo y la devuelve a su sitio. Lea las frases de abajo; esto es lo que debe hacer.',
  'tutorial.seekRefused': 'Estropéelo y vea dónde se rechaza',
  'tutorial.seekRefusedHow':
    'Haga clic en el objetivo que sigue a «mueve las articulaciones» y pulse `Supr`. Ejecutar está gris: encima dice qué falta, y un clic allí muestra dónde.',
  'tutorial.seekMended': 'Arréglelo',
  'tutorial.seekMendedHow': '`Ctrl Z`, o rellene otra vez el hueco. Ya no hay nada que impida ejecutarlo.',
  'tutorial.seekStops': 'Estropéelo de modo que se ejecute y se pare por el camino',
  'tutorial.seekStopsHow':
    'Ponga «cierra la mano» en lugar de «abre la mano». Un momento después la previsión, debajo de Ejecutar, dice qué pasará, y un icono queda marcado. Ejecútelo igualmente: ¿por qué se paró, y en qué icono? Después elija «Terminar la ejecución».',
  'tutorial.seekOwn': 'Averigüe: estropéelo de modo que nada lo pare y aun así no haga lo que debe',
  'tutorial.seekOwnHow':
    '`Ctrl Z` hasta que esté como antes; después cambie otra cosa y ejecútelo. Se hacen todas las acciones, así que ni Ejecutar ni la previsión dicen nada: ¿qué lo dice? Marcas, tiempos, frases, la célula. Cuenta cuando el programa cambiado ha llegado a su final.',
  'tutorial.course.faults': 'Encontrar un fallo',
  'tutorial.course.puzzles': 'Rompecabezas',
  'puzzle.title': 'Rompecabezas',
  'puzzle.say':
    'Una meta en la célula, alcanzada con un programa suyo. Una estrella por la meta, otra por pocas acciones, otra por poco tiempo. Cada ejecución empieza con la célula restablecida.',
  'puzzle.faults':
    'Doce programas, cada uno con un fallo. Empiece uno, mire lo que la página dice de él, ejecútelo, arréglelo. Se marca cuando el programa arreglado ha alcanzado su meta.',
  'puzzle.goal': 'Al final debe cumplirse:',
  'puzzle.par': 'Para tres estrellas: acciones como mucho {actions}, tiempo como mucho {s} s.',
  'puzzle.tries': 'Intentos hasta ahora: {n}',
  'puzzle.best': 'acciones: {actions}, tiempo: {s} s',
  'puzzle.bestSoFar': 'Lo mejor:',
  'puzzle.stars': '{n} de 3 estrellas',
  'puzzle.begin': 'Empezar',
  'puzzle.again': 'Empezar de nuevo',
  'puzzle.hint': 'Pista (quedan {n})',
  'puzzle.hintNumber': 'Pista {n}:',
  'puzzle.solved': 'Resuelto',
  'puzzle.mended': 'Arreglado',
  'puzzle.notYet': 'Todavía no',
  'puzzle.uncounted': 'Esta ejecución no cuenta: {why}.',
  'puzzle.so': 'así es',
  'puzzle.notSo': 'todavía no',
  'puzzle.exactly': 'Las condiciones exactas',
  'puzzle.holds': 'se cumple',
  'puzzle.found': 'no se cumple: era {value}',
  'puzzle.nothing': 'no se cumple: al final no había valor',
}
