function N(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))typeof r=="function"?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==void 0&&r!==!1&&n.setAttribute(s,String(r));return n.append(...e),n}function In(i){let t=document.getElementById(i);if(!t)throw new Error(`The page has no #${i}.`);return t}function le(i,t){i.textContent!==t&&(i.textContent=t)}function zs(){return N("div",{class:"figure",role:"img"})}function $i(i,t){i.getAttribute("aria-label")!==t&&i.setAttribute("aria-label",t)}var Rx=0,pm=()=>`e${++Rx}`;function mm(i){let t=In("drop"),e=n=>n.dataTransfer?.types.includes("Files")??!1;addEventListener("dragover",n=>{e(n)&&(n.preventDefault(),t.hidden=!1)}),addEventListener("dragleave",n=>{n.relatedTarget===null&&(t.hidden=!0)}),addEventListener("drop",n=>{t.hidden=!0;let[s]=n.dataTransfer?.files??[];s&&(n.preventDefault(),i(s))})}var Cx=/\[(\d+)\]|"((?:[^"\\]|\\.)*)"|([^.[\]"]+)/g;function gd(i){return[...i.matchAll(Cx)].map(([,t,e,n])=>t!==void 0?Number(t):e!==void 0?JSON.parse(`"${e}"`):n)}function yn(i){let t="";for(let e of i)typeof e=="number"?t+=`[${e}]`:t+=(t?".":"")+(/^[\w-]+$/.test(e)?e:JSON.stringify(e));return t}var De=i=>typeof i=="object"&&i!==null&&!Array.isArray(i);function gm(i,t){return Array.isArray(i)?typeof t=="number"?i[t]:void 0:De(i)&&Object.hasOwn(i,t)?i[t]:void 0}var jr=(i,t)=>t.reduce(gm,i);function ha(i,t,e){let[n,...s]=t;if(n===void 0)return e;let r=ha(gm(i,n),s,e);return typeof n=="number"?Object.assign(Array.isArray(i)?[...i]:[],{[n]:r}):{...De(i)?i:{},[n]:r}}function yd(i,t){let e=t.slice(0,-1),n=jr(i,e),s=t[t.length-1];if(s===void 0||jr(i,t)===void 0)return i;if(Array.isArray(n))return ha(i,e,n.filter((l,c)=>c!==s));let{[s]:r,...o}=n;return Object.keys(o).length===0&&typeof e[e.length-1]=="string"?yd(i,e):ha(i,e,o)}function gi(i,t){if(i===t)return!0;if(Array.isArray(i))return Array.isArray(t)&&i.length===t.length&&i.every((n,s)=>gi(n,t[s]));if(!De(i)||!De(t))return!1;let e=Object.keys(i);return e.length===Object.keys(t).length&&e.every(n=>Object.hasOwn(t,n)&&gi(i[n],t[n]))}var Hs=.5555555555555556,Jn=1.5,ym=1.75;var Px=[1,1.5,2,3,4,5,6,8],[gr,ua]=[.1,200];function _m(i,t){if(!(i>0))return 1;let e=Math.min(Math.max(ym*t/(10*i),gr),ua),n=10**Math.floor(Math.log10(e)+1e-9);return n*Px.reduce((s,r)=>r*n<=e*(1+1e-9)?r:s,1)}function xm(i){let t=gr*(ua/gr)**(i/1e3);return Number(t.toPrecision(2))}function vm(i){return Math.round(1e3*Math.log(i/gr)/Math.log(ua/gr))}var Ix=2,Lx=1/50;function _d(){return{trial:0,time:0,exaggeration:0,speed:.25,span:"trial",playing:!Sm()}}function bm(i){let t=typeof i=="object"&&i!==null?i:{},e=_d(),n=(s,r)=>{let o=t[s];return typeof o=="number"&&Number.isFinite(o)&&r(o)?o:e[s]};return{trial:n("trial",s=>Number.isSafeInteger(s)&&s>=0),time:n("time",s=>s>=0),exaggeration:n("exaggeration",s=>s===0||s>=gr&&s<=ua),speed:n("speed",s=>s>=Lx&&s<=Ix),span:t.span==="trial"||t.span==="run"?t.span:e.span,playing:typeof t.playing=="boolean"?t.playing&&!Sm():e.playing}}var Sm=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var Dx=4e6;async function Mm(i){let t=await Tm(new TextEncoder().encode(JSON.stringify(i)),new CompressionStream("deflate-raw")),e=Array.from(t,n=>String.fromCharCode(n)).join("");return`#s=${btoa(e).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}async function wm(i){let[,t]=/^#s=(.*)$/.exec(i)??[];if(t===void 0)return null;let e=atob(t.replaceAll("-","+").replaceAll("_","/")),n=Uint8Array.from(e,a=>a.charCodeAt(0)),s=await Tm(n,new DecompressionStream("deflate-raw")),r=JSON.parse(new TextDecoder().decode(s)),o=r?.table;if(r?.v!==1||typeof r.preset!="string"||!De(o))throw new Error("The link holds no state.");return{v:1,preset:r.preset,table:o,view:bm(r.view)}}async function Tm(i,t){let e=new Blob([i]).stream().pipeThrough(t).getReader(),n=[],s=0;for(let a=await e.read();!a.done;a=await e.read())if(n.push(a.value),s+=a.value.length,s>Dx)throw new Error("The link holds too much.");let r=new Uint8Array(s),o=0;for(let a of n)r.set(a,o),o+=a.length;return r}var Nx=600,Pl=class{constructor(t){this.state=t}state;timer=0;read(){return wm(location.hash)}renew(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.write()},Nx)}async write(){history.replaceState(null,"",await Mm(this.state()))}};function da(i,t,e=[]){return gi(i,t)?[]:De(i)&&De(t)&&i.kind===t.kind?[...new Set([...Object.keys(i),...Object.keys(t)])].flatMap(s=>da(i[s],t[s],[...e,s])):Em(i)&&Em(t)&&i.length===t.length?i.flatMap((n,s)=>da(n,t[s],[...e,s])):[{path:e,before:i,after:t}]}var Em=i=>Array.isArray(i)&&i.every(De);function yr(i){if(i===void 0)return"left out";if(Array.isArray(i))return`[${i.map(yr).join(", ")}]`;if(!De(i))return String(i).replace(/^-(?=\d)/,"−");let{kind:t,...e}=i,n=Object.entries(e).map(([s,r])=>`${s} = ${yr(r)}`);return[...t===void 0?[]:[String(t)],...n].join(", ")||"empty"}function Am(i,t,e){let n=da(e,t),s=n.slice(0,2).map(({path:o,after:a})=>{let l=De(a)&&a.kind!==void 0?String(a.kind):yr(a);return`${o[o.length-1]} = ${l.length>24?`${l.slice(0,22)}…`:l}`}),r=n.length>s.length?[`${n.length-s.length} more`]:[];return[i,...s,...r].join(", ")}var Il=class{constructor(t,e,n){this.schema=t;this.scenario=e;this.attach=n}schema;scenario;attach;ports=[];sliders={};kinds(t){return this.schema.kinds[t]??[]}};var Ll=class{constructor(t){this.form=t}form;element=N("div",{class:"changes",hidden:!0});count_=0;get count(){return this.count_}update(){let{scenario:t}=this.form,e=da(t.preset.table,t.table);if(this.count_=e.length,this.element.hidden)return;let n=N("p",{class:"about"},`Nothing differs from ${t.preset.name}.`);this.element.replaceChildren(e.length===0?n:N("ul",{},...e.map(s=>this.line(s))))}show(t){this.element.hidden=!t,this.update()}line({path:t,before:e,after:n}){let s=yn(t);return N("li",{},N("code",{},s),N("span",{class:"values"},N("del",{},Cm(e))," → ",N("ins",{},Cm(n))),N("button",{type:"button",class:"quiet","aria-label":`Revert ${s}`,onclick:()=>this.form.scenario.revert(t)},"revert"))}},Rm=60;function Cm(i){let t=yr(i);return t.length>Rm?`${t.slice(0,Rm)}…`:t}var Fx="-0123456789n",Ux="⁻⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ",Qr=i=>i.replace(/\^(-?[\dn]+)/g,(t,e)=>[...e].map(n=>Ux[Fx.indexOf(n)]).join(""));function fa(i){let t=i.trim().replace(/^−/,"-").replace(/e−/i,"e-"),e=/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(t)?Number(t):NaN;return Number.isFinite(e)?e:void 0}var to=(i,t)=>Number(i.toPrecision(t)),fs=i=>String(to(i,6)).replaceAll("-","−"),Pm=i=>i<1?`${Math.max(1,Math.round(i*1e3))} ms`:`${i.toFixed(i<10?1:0)} s`;var Un=i=>i.split("`").map((t,e)=>e%2===1?N("code",{},t):t),Dl=i=>i.replaceAll("`","");function Im({doc:i,range:t,default:e,required:n,unit:s}){let r=[i,Ox(t),s&&`In ${Qr(s)}`];return n?r.push("Needed"):pa(e)||r.push(`Default ${typeof e=="number"?fs(e):yr(e)}`),r.filter(Boolean).map(kx).join(" ")}function Ox({gt:i,ge:t,lt:e,le:n}){let s=i!==void 0?`greater than ${fs(i)}`:t!==void 0?`at least ${fs(t)}`:"",r=e!==void 0?`less than ${fs(e)}`:n!==void 0?`at most ${fs(n)}`:"";return[s,r].filter(Boolean).join(", ")}var kx=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.;:!?]$/.test(i)?"":"."),pa=i=>i===void 0||i===""||typeof i=="object"&&Object.keys(i).length===0;function Lm(i,{unit:t}){let[e,n]=t.split(",").map(s=>s.trim());return n===void 0?e??"":(i?.kind==="torque"?n:i&&e)||""}function Dm(i){switch(i.is){case"number":case"integer":return"number";case"list":return i.of.is==="list"?"matrix":"list";case"component":return"table";case"kind":return i.family;case"function":return"code of your own";default:return i.is}}function Nm(i,t){let e=[...i.querySelectorAll("[data-error]:not([data-typed])")].map(r=>({element:r,path:gd(r.dataset.error??"")})),n=new Map(e.map(({element:r})=>[r,[]])),s=[];for(let r of t){let o=gd(r.at),[a]=e.filter(l=>Bx(o,l.path)).sort((l,c)=>c.path.length-l.path.length);a?n.get(a.element)?.push(a.path.length<o.length?`${r.at} ${r.text}`:r.text):s.push(r)}for(let[r,o]of n)r.replaceChildren(...Un(o.join(" "))),zx(i,r,o.length>0);return s}var Bx=(i,t)=>t.length>0&&t.every((e,n)=>e===i[n]);function zx(i,t,e){if(t.id&&i.querySelector(`[data-path][aria-describedby~="${t.id}"]`)?.setAttribute("aria-invalid",String(e)),!!e)for(let n=t.closest("details");n;n=n.parentElement?.closest("details")??null)n.open=!0}var Nl=class{constructor(t){this.root=t}root;folds=null;apply(t){let e=t.toLowerCase().split(/\s+/).filter(Boolean);if(this.root.classList.toggle("filtering",e.length>0),e.length===0){for(let n of this.root.querySelectorAll("[data-passed]"))delete n.dataset.passed;return this.folds?.forEach((n,s)=>s.open=n),this.folds=null,null}return this.folds??=new Map([...this.root.querySelectorAll("details")].map(n=>[n,n.open])),xd(this.root,n=>e.every(s=>n.includes(s)),!1)}};function xd(i,t,e){let n=0;for(let s of i.children){if(!(s instanceof HTMLElement))continue;let{words:r,group:o}=s.dataset,a=e||r!==void 0&&t(r);if(r===void 0&&o===void 0){n+=xd(s,t,e);continue}let l=o===void 0?0:xd(s,t,a),c=l>0||a;s.dataset.passed=String(c),c&&s instanceof HTMLDetailsElement&&(s.open=!0),n+=l>0?l:Number(a)}return n}var Fl=class{constructor(t,e,n){this.form=t;this.plan=e;let{key:s,title:r}=e;this.wanted=!e.onDemand,this.field=e.make(t),this.add=N("button",{type:"button",class:"add",onclick:()=>this.unfold()},`Add ${r.toLowerCase()}`),this.details=N("details",{class:"section","data-group":"","data-section":s,open:n},N("summary",{},N("h2",{},r),this.mark,this.gist),N("p",{class:"about"},...Un(t.schema.tables[s]?.summary??"")),this.remark,N("p",{class:"error","data-error":s}),this.field.element),this.element=N("div",{},this.add,this.details),this.update()}form;plan;element;details;add;gist=N("span",{class:"gist"});mark=N("span",{class:"mark",hidden:!0},N("span",{class:"unseen"},"changed from the preset"));remark=N("p",{class:"about"});field;wanted;update(){let{form:t,plan:e}=this,n=t.scenario.value([e.key]),s=this.wanted||n!==void 0;this.details.hidden=!s,this.add.hidden=s,this.mark.hidden=!t.scenario.differs([e.key]),le(this.gist,De(n)&&typeof n.kind=="string"?n.kind:""),le(this.remark,e.remark?.(t.scenario.table)??""),this.field.update()}unfold(){this.wanted=!0,this.update(),this.details.open=!0,this.details.querySelector("summary")?.focus()}};var Ul=class{constructor(t,e,n,s){this.form=t;this.path=e;this.parameter=n;this.types=s;let r=s.filter(({is:l})=>l!=="function"),o=s.map((l,c)=>N("option",{value:c,disabled:l.is==="function"},Dm(l))),a={"aria-label":`${n.name}: form`,"data-form":yn(e)};this.select=N("select",{class:"form",...a},...o),this.select.addEventListener("change",()=>this.choose(Number(this.select.value))),this.select.hidden=r.length<2,this.update()}form;path;parameter;types;element=N("div",{});select;chosen=-1;inner=null;seen;update(){let t=this.form.scenario.value(this.path),e=this.chosen>=0&&t===this.seen&&t===void 0;this.seen=t;let n=e?this.chosen:this.formOf(t??this.parameter.default);n!==this.chosen?this.build(n):this.inner?.update()}formOf(t){let e=this.types.findIndex(s=>t!==void 0&&ma(s,t)),n=typeof t=="string"?this.types.findIndex(({is:s})=>s==="function"):-1;return e>=0?e:Math.max(0,n)}build(t){let e=this.types[t];if(!e)return;this.chosen=t,this.select.value=String(t);let{default:n,...s}=this.parameter,r=n!==void 0&&ma(e,n)?{default:n}:{},o={...s,...r,type:e};this.inner=e.is==="component"?new vd(this.form,this.path,e):eo(this.form,this.path,o),this.element.replaceChildren(this.inner.element),this.element.querySelector(".naming")?.append(this.select)}choose(t){let e=this.types[t];if(!e)return;let n=Hx(this.form.scenario.value(this.path)??this.parameter.default,e,this.form);this.build(t),n===void 0?this.form.scenario.remove(this.path):this.form.scenario.set(this.path,n),this.seen=this.form.scenario.value(this.path),this.chosen!==t&&this.build(t),this.select.focus()}},vd=class{element;inner;constructor(t,e,n){this.inner=new Ai(t,e,n.parameters);let s=String(e[e.length-1]);this.element=N("div",{class:"unfolded","data-group":"",role:"group","aria-label":s},N("div",{class:"naming"},N("span",{class:"name"},s)),N("p",{class:"about"},...Un(n.summary)),N("p",{class:"error","data-error":yn(e)}),this.inner.element)}update(){this.inner.update()}};function ma(i,t){switch(i.is){case"number":case"integer":return typeof t=="number";case"boolean":return typeof t=="boolean";case"text":case"file":return typeof t=="string";case"choice":return typeof t=="string"&&i.of.includes(t);case"list":return Array.isArray(t)&&t.every(e=>ma(i.of,e));case"kind":return De(t)&&"kind"in t;case"table":case"component":return De(t)&&!("kind"in t);case"any":return i.of.some(e=>ma(e,t));case"function":return!1}}function Hx(i,t,e){let n=Array.isArray(i)?i[i.length-1]:i;switch(t.is){case"number":case"integer":return typeof n=="number"?n:void 0;case"list":return typeof n=="number"&&t.of.is==="number"?[n]:void 0;case"kind":{let[s]=e.kinds(t.family);return s&&{kind:s.kind}}case"component":{let s=t.parameters.find(({required:r})=>r);return s&&n!==void 0&&ma(s.type,n)?{[s.name]:n}:void 0}default:return}}var _r=class extends Error{constructor(e){super(e.map(({at:n,text:s})=>n?`${n} ${s}`:s).join(" "));this.faults=e}faults},Vx={"X-Dampen":"lab"},Fm=()=>Sd("/schema"),Um=()=>Sd("/start"),bd=i=>Sd(`/scenario/${encodeURIComponent(i)}`);async function Om(i){return await(await Md(`/read?name=${encodeURIComponent(i.name)}`,i)).json()}async function km(i){return(await(await Md(`/attach?name=${encodeURIComponent(i.name)}`,i)).json()).attachment}async function Bm(i,t,e){let n=await Md(`/download/${i}`,JSON.stringify({table:t,token:e})),s=/filename="?([^";]+)"?/.exec(n.headers.get("Content-Disposition")??"")?.[1]??`dampen-${i}`,r=URL.createObjectURL(await n.blob()),o=document.createElement("a");o.href=r,o.download=s,o.click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}async function Sd(i){let t=await fetch(i);if(!t.ok)throw new Error(`The server has no ${i}.`);return await t.json()}async function Md(i,t){let n=await fetch(i,{method:"POST",headers:{...Vx,"Content-Type":typeof t=="string"?"application/json":"application/octet-stream"},body:t});if(n.ok)return n;let s=await n.json().catch(()=>null);throw new _r(s?.faults??[{at:"",text:`The server could not do this (${n.status}).`}])}var Ln=class{constructor(t,e,n,s=!1){this.form=t;this.path=e;this.parameter=n;this.group=s;this.at=yn(e),this.error=N("p",{class:"error",id:`${this.id}-error`,"data-error":this.at});let r=s?N("span",{class:"name",id:`${this.id}-name`},n.name):N("label",{class:"name",for:this.id},n.name),o=N("p",{class:"help",id:`${this.id}-help`},...Un(Im(n)));this.reset=N("button",{type:"button",class:"quiet",hidden:!0,onclick:()=>t.scenario.remove(e)}),this.element=N("div",{class:"field","data-at":this.at,"data-words":`${this.at} ${n.doc}`.toLowerCase()},N("div",{class:"naming"},r,this.mark,N("span",{class:"unit"},Qr(n.unit)),N("span",{class:"brief","aria-hidden":"true"},Dl(n.doc)),this.reset,...n.doc?[Gx(n.name,o)]:[]),this.body,o,this.error),s&&(this.element.setAttribute("role","group"),this.element.setAttribute("aria-labelledby",`${this.id}-name`),this.element.setAttribute("aria-describedby",this.descriptions))}form;path;parameter;group;element;body=N("div",{class:"entry"});id=pm();at;mark=N("span",{class:"mark",hidden:!0},N("span",{class:"unseen"},"changed from the preset"));error;reset;get control(){let{id:t,at:e}=this;return{id:t,"data-path":e,"aria-describedby":this.descriptions,autocomplete:"off",spellcheck:"false"}}get slider(){return{"data-slider":this.at,"aria-label":`${this.parameter.name}, slider`,"aria-describedby":this.descriptions}}update(){let{form:t,path:e,parameter:n}=this;this.mark.hidden=!t.scenario.differs(e);let s=t.scenario.value(e);this.reset.hidden=n.required||s===void 0||gi(s,n.default);let r=pa(n.default)?"leave out":"default";le(this.reset,r);let o=r==="default"?`${n.name}: back to the default`:`${n.name}: leave out`;this.reset.setAttribute("aria-label",o)}fail(t){let e="typed"in this.error.dataset;!t&&!e||(this.error.toggleAttribute("data-typed",t!==""),le(this.error,t),this.group||this.body.querySelector(`#${this.id}`)?.setAttribute("aria-invalid",String(t!=="")))}get descriptions(){return`${this.id}-help ${this.id}-error`}};function Gx(i,t){let e=N("button",{type:"button",class:"ask","aria-label":`What is ${i}?`,"aria-expanded":"false","aria-controls":t.id},"?");return e.addEventListener("click",()=>{let n=e.getAttribute("aria-expanded")!=="true";e.setAttribute("aria-expanded",String(n)),t.classList.toggle("open",n)}),e}var wd="",Ol=class{constructor(t,e,n,s){this.form=t;this.path=e;this.row=new Ln(t,e,n),this.element=this.row.element;let{required:r,default:o}=n,a=r?"needed":o===void 0?"left out":`${String(o)} (default)`,l=s.map(c=>N("option",{value:c},c));this.select=N("select",this.row.control,N("option",{value:wd},a),...l),this.select.addEventListener("change",()=>{this.select.value===wd?t.scenario.remove(e):t.scenario.set(e,this.select.value)}),this.row.body.append(this.select),this.update()}form;path;element;row;select;update(){this.row.update();let t=this.form.scenario.value(this.path);this.select.value=t===void 0?wd:String(t)}},kl=class{constructor(t,e,n){this.form=t;this.path=e;this.parameter=n;this.row=new Ln(t,e,n),this.element=this.row.element,this.input=N("input",{type:"checkbox",role:"switch",...this.row.control}),this.input.addEventListener("change",()=>t.scenario.set(e,this.input.checked)),this.row.body.append(this.input,this.word),this.update()}form;path;parameter;element;row;input;word=N("span",{class:"word","aria-hidden":"true"});update(){this.row.update(),this.input.checked=(this.form.scenario.value(this.path)??this.parameter.default)===!0,le(this.word,this.input.checked?"yes":"no")}},Bl=class{constructor(t,e,n){this.form=t;this.path=e;this.row=new Ln(t,e,n),this.element=this.row.element;let s=N("input",{type:"file",...this.row.control,onchange:()=>{this.take(s)}});this.row.body.append(this.name,s),this.update()}form;path;element;row;name=N("output",{class:"file"});update(){this.row.update(),le(this.name,String(this.form.scenario.value(this.path)??"no file yet"))}async take(t){let[e]=t.files??[];if(e){this.row.fail("");try{this.form.scenario.set(this.path,await this.form.attach(e))}catch(n){this.row.fail(n instanceof _r?n.message:"The file did not reach the server.")}t.value=""}}},zl=class{constructor(t,e,n){this.form=t;this.path=e;this.row=new Ln(t,e,n),this.element=this.row.element;let s="code of your own: edit the scenario file";this.input=N("input",{type:"text",disabled:!0,placeholder:s,...this.row.control}),this.row.body.append(this.input),this.update()}form;path;element;row;input;update(){this.row.update();let t=this.form.scenario.value(this.path);this.input.value=t===void 0?"":String(t),this.input.title=yn(this.path)}};var Hl="",Vs=class{constructor(t,e,n,s){this.form=t;this.path=e;this.family=s;let r=[...e,"kind"];this.row=new Ln(t,n.required?r:e,n);let o=t.kinds(s),a=n.required?"needed":"left out";this.select=N("select",{...this.row.control,"data-path":yn(r)},N("option",{value:Hl},a),...o.map(({kind:l})=>N("option",{value:l},l))),this.select.addEventListener("change",()=>{this.select.value===Hl?t.scenario.remove(e):t.scenario.set(e,{kind:this.select.value})}),this.row.body.append(this.select),this.element=N("div",{class:"kind","data-group":""},this.row.element,this.about,this.body),this.update()}form;path;family;element;row;select;about=N("p",{class:"about"});body=N("div",{});inner=null;shown=null;update(){this.row.update();let t=String(this.form.scenario.value([...this.path,"kind"])??Hl);t!==this.shown?this.build(t):this.inner?.update()}build(t){this.shown=t,this.select.value=t;let e=this.form.kinds(this.family).find(s=>s.kind===t),n=t===Hl?"":`“${t}” is code of your own: edit the scenario file.`;this.about.replaceChildren(...Un(e?.summary??n)),this.inner=e?new Ai(this.form,this.path,e.parameters):null,this.body.replaceChildren(...this.inner?[this.inner.element]:[])}};var no=1e3,zm=30,Wx=3,Xx=10;function Td(i,{type:t,range:e}){if(i===void 0)return null;let n=t.is==="integer",s=Math.max(e.ge??-1/0,e.gt??-1/0),r=Math.min(e.le??1/0,e.lt??1/0),o=Number.isFinite(s)&&Number.isFinite(r),a=n&&r-s>Xx*Math.abs(i);if(o&&!a)return ga({low:s,high:r,log:!1,whole:n},e);if(i===0)return null;if(i>0){let c=Math.max(to(i/zm,3),s,n?1:0);return ga({low:c,high:Math.min(to(i*zm,3),r),log:!0,whole:n},e)}let l=to(Wx*Math.abs(i),3);return ga({low:Math.max(-l,s),high:Math.min(l,r),log:!1,whole:n},e)}function ga(i,{gt:t=-1/0,lt:e=1/0}){let n=i.whole?Math.ceil(i.low):i.low,s=i.whole?Math.floor(i.high):i.high,r=i.whole?1:(s-n)/no;return{...i,low:n<=t?t+r:n,high:s>=e?e-r:s}}var Hm=(i,t)=>i.low<=t&&t<=i.high;function Vm({low:i,high:t,log:e},n){let s=e?Math.log(n/i)/Math.log(t/i):(n-i)/(t-i);return Math.round(no*Math.min(1,Math.max(0,Number.isNaN(s)?0:s)))}function Ed({low:i,high:t,log:e,whole:n},s){let r=s/no,o=e?i*(t/i)**r:i+(t-i)*r,a=Math.max(0,Math.ceil(-Math.log10((t-i)/no))),l=n?Math.round(o):e?to(o,3):Number(o.toFixed(Math.min(a,20)));return Math.min(Math.max(l,i),t)}function Vl(i,t,e){let n=0;i.addEventListener("input",()=>{clearTimeout(n),/(^|[\s,])[-−+.]?$|[.e]$|e[-−+]$/i.test(i.value)||(n=window.setTimeout(t,350))}),i.addEventListener("change",()=>{clearTimeout(n),t(),e()})}var Gl=class{constructor(t,e,n){this.form=t;this.path=e;this.parameter=n;this.at=yn(e),this.row=new Ln(t,e,n),this.element=this.row.element,this.slider=N("input",{type:"range",min:0,max:no,step:1,hidden:!0,...this.row.slider}),this.input=N("input",{type:"text",inputmode:(n.range.ge??n.range.gt??-1)>=0?"decimal":"text",placeholder:this.placeholder,"aria-required":n.required?"true":void 0,...this.row.control}),this.row.body.append(this.slider,this.input),this.slider.addEventListener("input",()=>this.slide()),this.slider.addEventListener("change",()=>t.scenario.settle()),Vl(this.input,()=>this.typed(),()=>t.scenario.settle()),this.update()}form;path;parameter;element;row;input;slider;at;scale=null;update(){let t=this.form.scenario.value(this.path);this.row.update(),this.show(t);let e=t??this.parameter.default,n=typeof e=="number"?e:void 0;(document.activeElement!==this.slider||!this.holds(n))&&this.rescale(n),this.slider.hidden=this.scale===null,this.slider.classList.toggle("unset",t===void 0),!(!this.scale||n===void 0)&&(Ed(this.scale,Number(this.slider.value))!==n&&(this.slider.value=String(Vm(this.scale,n))),this.slider.setAttribute("aria-valuetext",`${fs(n)} ${Qr(this.parameter.unit)}`.trim()))}get placeholder(){let{required:t,default:e}=this.parameter;return t?"needed":typeof e=="number"?fs(e):"left out"}show(t){let e=t===void 0?"":String(t);this.input.value!==e&&(e===""||fa(this.input.value)!==t)&&(this.input.value=e,this.row.fail(""))}rescale(t){let e=this.form.sliders[this.at];e&&t!==void 0&&e.low<=t&&t<=e.high?this.scale=ga({...e,whole:this.parameter.type.is==="integer"},this.parameter.range):this.holds(t)||(this.scale=Td(t,this.parameter))}holds(t){return this.scale!==null&&(t===void 0||Hm(this.scale,t))}slide(){this.scale&&this.form.scenario.set(this.path,Ed(this.scale,Number(this.slider.value)),`slide ${this.at}`)}typed(){if(this.input.value.trim()===""){this.row.fail(""),this.form.scenario.remove(this.path);return}let t=fa(this.input.value),e=this.parameter.type.is==="integer";if(t===void 0)return this.row.fail("This is not a number.");if(e&&!Number.isInteger(t))return this.row.fail("This must be a whole number.");if(e&&!Number.isSafeInteger(t))return this.row.fail("This whole number is too large.");this.row.fail(""),this.form.sliders[this.at]||(this.scale=Td(t,this.parameter)),this.form.scenario.set(this.path,t,`type ${this.at}`)}};var io=class{constructor(t,e,n,s,r={}){this.form=t;this.path=e;this.parameter=n;this.of=s;this.more=r;this.row=new Ln(t,e,{...n,unit:""},!0),this.row.body.append(this.rows),this.element=this.row.element,this.element.setAttribute("data-group",""),this.update()}form;path;parameter;of;more;element;row;rows=N("div",{class:"by-port"});fields=[];names="";update(){this.row.update();let t=this.form.scenario.value(this.path),e=this.form.ports.map(({name:r})=>r),n=new Set([...e,...Object.keys(this.more),...De(t)?Object.keys(t):[]]),s=JSON.stringify([...n].map(r=>[r,this.unit(r)]));if(s===this.names){for(let r of this.fields)r.update();return}this.names=s,this.fields=[...n].map(r=>this.field(r)),this.rows.replaceChildren(...this.fields.map(r=>r.element))}unit(t){return this.more[t]??Lm(this.form.ports.find(e=>e.name===t),this.parameter)}field(t){let{range:e}=this.parameter,n={name:t,type:this.of,unit:this.unit(t),doc:"",range:e,required:!1};return eo(this.form,[...this.path,t],n)}};var qx={write:String,read:i=>i.trim()},$x=i=>({write:t=>Array.isArray(t)?t.map(String).join(", "):String(t),read:t=>{let e=t.replace(/^\s*\[|\]\s*$/g,"").split(/[,;]/).map(n=>n.trim()).filter(Boolean);return i.is==="integer"?e.map(Zx):i.is==="number"?e.map(Gm):e}}),Yx={write:i=>JSON.stringify(i),read:i=>{try{if(JSON.stringify(JSON.parse(i)).includes("null"))throw new Error;return JSON.parse(i)}catch{throw new Error("Write rows of numbers in brackets: [[1, 0], [0, 1]].")}}};function Gm(i){let t=fa(i);if(t===void 0)throw new Error(`“${i}” is not a number.`);return t}function Zx(i){let t=Gm(i);if(!Number.isSafeInteger(t))throw new Error(`“${i}” is not a whole number, or too large.`);return t}function Jx(i){return i.is!=="list"?qx:i.of.is==="list"?Yx:$x(i.of)}var ya=class{constructor(t,e,n){this.form=t;this.path=e;let{required:s,default:r,type:o}=n;this.notation=Jx(o),this.row=new Ln(t,e,n),this.element=this.row.element;let a=r===void 0||pa(r)?"":this.notation.write(r);this.input=N("input",{type:"text",placeholder:s?"needed":a||(o.is==="list"?"none":"left out"),"aria-required":s?"true":void 0,...this.row.control}),this.row.body.append(this.input),Vl(this.input,()=>this.typed(),()=>t.scenario.settle()),this.update()}form;path;element;row;input;notation;shown;update(){this.row.update();let t=this.form.scenario.value(this.path);t!==this.shown&&(this.shown=t,this.input.value=t===void 0?"":this.notation.write(t),this.row.fail(""))}typed(){try{let e=this.input.value.trim()===""?void 0:this.notation.read(this.input.value);this.row.fail(""),this.shown=e,e===void 0?this.form.scenario.remove(this.path):this.form.scenario.set(this.path,e,`type ${yn(this.path)}`),this.shown=this.form.scenario.value(this.path)}catch(t){this.row.fail(t.message)}}};function eo(i,t,e){let{type:n}=e;switch(n.is){case"number":case"integer":return new Gl(i,t,e);case"boolean":return new kl(i,t,e);case"choice":return new Ol(i,t,e,n.of);case"text":return new ya(i,t,e);case"file":return new Bl(i,t,e);case"function":return new zl(i,t,e);case"list":{let{of:s}=n;return s.is==="kind"||s.is==="component"?new so(i,t,e,s):new ya(i,t,e)}case"table":return new io(i,t,e,n.of);case"component":return new Wl(i,t,e,n);case"kind":return new Vs(i,t,e,n.family);case"any":return new Ul(i,t,e,n.of)}}var Ai=class{element=N("div",{class:"parameters"});fields;constructor(t,e,n){this.fields=n.map(s=>eo(t,[...e,s.name],s)),this.element.append(...this.fields.map(s=>s.element))}update(){for(let t of this.fields)t.update()}},Wl=class{constructor(t,e,n,s){this.form=t;this.path=e;let r=yn(e);this.inner=new Ai(t,e,s.parameters);let o=N("details",{class:"group","data-group":""},N("summary",{},N("span",{class:"name"},n.name),this.mark),N("p",{class:"about"},...Un(n.doc||s.summary)),N("p",{class:"error","data-error":r}),this.inner.element);o.open=De(t.scenario.value(e)),this.element=o,this.update()}form;path;element;mark=N("span",{class:"mark",hidden:!0},N("span",{class:"unseen"},"changed from the preset"));inner;update(){this.mark.hidden=!this.form.scenario.differs(this.path),this.inner.update()}};var so=class{constructor(t,e,n,s){this.form=t;this.path=e;this.item=s;this.row=new Ln(t,e,n,!0);let r=N("button",{type:"button",class:"add","data-add":yn(e),onclick:()=>this.add()},`Add to ${n.name}`);this.row.body.append(this.list,r),this.element=this.row.element,this.element.removeAttribute("data-words"),this.element.setAttribute("data-group",""),this.update()}form;path;item;element;row;list=N("ol",{class:"cards"});cards=[];shape="";update(){this.row.update();let{items:t}=this,e=t.map(n=>De(n)?String(n.kind??""):"?").join("|");if(e===this.shape&&t.length===this.cards.length){for(let n of this.cards)n.update();return}this.shape=e,this.cards=t.map((n,s)=>this.card(s)),this.list.replaceChildren(...this.cards.map((n,s)=>N("li",{class:"card"},this.tools(s),n.element)))}get items(){let t=this.form.scenario.value(this.path);return Array.isArray(t)?t:[]}card(t){let e=[...this.path,t];if(this.item.is==="component")return new Ai(this.form,e,this.item.parameters);let n={name:`${this.item.family} ${t+1}`,type:this.item,unit:"",doc:"",range:{},required:!0};return new Vs(this.form,e,n,this.item.family)}tools(t){let e=(n,s,r,o=!1)=>N("button",{type:"button",class:"tool",disabled:o,"aria-label":`${s} ${t+1}`,onclick:r},n);return N("div",{class:"tools"},e("↑","Move up",()=>this.move(t,t-1),t===0),e("↓","Move down",()=>this.move(t,t+1),t===this.items.length-1),e("×","Remove",()=>this.remove(t)))}add(){let t=this.item.is==="kind"?{kind:this.form.kinds(this.item.family)[0]?.kind??""}:{};this.form.scenario.set(this.path,[...this.items,t]),this.focus(this.cards.length-1,"select, input")}move(t,e){let n=[...this.items],[s]=n.splice(t,1);s!==void 0&&(n.splice(e,0,s),this.form.scenario.set(this.path,n),this.focus(e,`.tools button:nth-child(${t<e?2:1}):enabled`))}remove(t){this.form.scenario.set(this.path,this.items.filter((e,n)=>n!==t)),this.focus(Math.min(t,this.cards.length-1),".tools button:last-child")}focus(t,e){let n=this.list.children[t];(n?.querySelector(e)??n?.querySelector(".tools button:enabled")??this.element.querySelector(".add"))?.focus()}};var Gs="all",Xl=class{constructor(t,e,n){this.form=t;this.path=e;this.family=n;let s=r=>N("input",{type:"radio",name:`chains-${n}`,onchange:r});this.same=s(()=>this.join()),this.each=s(()=>this.split()),this.element=N("div",{"data-group":""},N("fieldset",{class:"segments"},N("legend",{class:"unseen"},"Chains"),N("label",{},this.same,N("span",{},"same for all ports")),N("label",{},this.each,N("span",{},"port by port"))),this.lists),this.update()}form;path;family;element;same;each;lists=N("div",{});fields=[];names="";update(){let t=Object.keys(this.tables),e=t.some(r=>r!==Gs),n=this.form.ports.map(({name:r})=>r),s=e?[...new Set([...t,...n])]:[Gs];if(this.same.checked=!e,this.each.checked=e,this.each.disabled=n.length===0&&!e,s.join()===this.names){for(let r of this.fields)r.update();return}this.names=s.join(),this.fields=s.map(r=>this.list(r,e)),this.lists.replaceChildren(...this.fields.map(r=>r.element))}list(t,e){let n="Stages between the command and what is delivered, in this order. Without any, the command goes through as it is.",s={is:"kind",family:this.family},r={name:t!==Gs?t:e?"all other ports":"all ports",type:{is:"list",of:s},unit:"",doc:n,range:{},required:!1};return new so(this.form,[...this.path,t,"chain"],r,s)}get tables(){let t=this.form.scenario.value(this.path);return De(t)?t:{}}chain(t){return this.form.scenario.value([...this.path,t,"chain"])??[]}split(){let t=this.form.ports.map(({name:e})=>e);this.form.scenario.set(this.path,Object.fromEntries(t.map(e=>[e,{chain:this.chain(Gs)}])))}join(){let[t]=Object.keys(this.tables);this.form.scenario.set(this.path,{[Gs]:{chain:this.chain(Gs in this.tables?Gs:t??Gs)}})}};var Ad=(i,t)=>({key:i,title:t,make:e=>{let n={is:"kind",family:i};return new Vs(e,[i],{name:"kind",type:n,unit:"",doc:"",range:{},required:!0},i)}}),Wm=(i,t)=>({key:i,title:t,make:e=>new Xl(e,[i],i)}),ql=(i,t)=>({key:i,title:t,make:e=>new Ai(e,[i],e.schema.tables[i]?.parameters??[])}),Kx={f:"N/m"},jx={key:"bounds",title:"Bounds",make:i=>{let n={name:"bounds",type:{is:"table",of:{is:"number"}},unit:"N, N m",doc:"what the controller is told of the disturbances: at each port, and along the structure",range:{ge:0},required:!1};return new io(i,["bounds"],n,{is:"number"},Kx)}},Qx=({numerics:i})=>typeof i=="object"&&!Array.isArray(i)&&i.mode==="sampled",Xm=[Ad("controller","Controller"),Wm("actuator","Actuators"),{...Wm("compensation","Compensation"),onDemand:!0},Ad("disturbance","Disturbance"),Ad("plant","Plant"),ql("task","Task"),jx,{...ql("sampling","Sampling"),remark:i=>Qx(i)?"":"Without effect while numerics.mode is not “sampled”."},ql("numerics","Numerics"),ql("output","Output")];var tv=2,$l=class{constructor(t,e){this.form=e;this.sections=Xm.map((n,s)=>new Fl(e,n,s<tv)),this.folds.append(...this.sections.map(n=>n.element)),this.changes=new Ll(e),this.only=N("button",{type:"button","aria-pressed":"false",onclick:()=>this.showOnlyChanges(!this.folds.hidden)}),this.search.addEventListener("input",()=>this.sift()),t.replaceChildren(N("div",{class:"finding"},this.search,this.only),this.found,this.faults,this.changes.element,this.folds),this.update()}form;sections;folds=N("div",{class:"sections"});filter=new Nl(this.folds);search=N("input",{type:"search",placeholder:"Find a parameter","aria-label":"Find a parameter",autocomplete:"off"});found=N("p",{class:"about",role:"status"});faults=N("ul",{class:"faults","aria-label":"Faults"});changes;only;faulty=!1;told="";update(){for(let e of this.sections)e.update();this.changes.update();let{count:t}=this.changes;le(this.only,t===0?"Changes":`Changes (${t})`),this.search.value&&this.sift()}learn({ports:t,sliders:e}){let n=JSON.stringify([t,e]);n!==this.told&&(this.told=n,this.form.ports=t,this.form.sliders=e,this.update())}show(t){if(t.length===0&&!this.faulty)return;this.faulty=t.length>0;let e=Nm(this.folds,t);this.faults.replaceChildren(...e.map(({at:n,text:s})=>N("li",{},...Un(n?`${n} ${s}`:s)))),t.length>0&&e.length<t.length&&this.showOnlyChanges(!1)}showOnlyChanges(t){this.only.setAttribute("aria-pressed",String(t)),this.folds.hidden=t,this.changes.show(t)}sift(){this.showOnlyChanges(!1);let t=this.filter.apply(this.search.value),e=t===1?"1 parameter":`${t} parameters`;le(this.found,t===null?"":t===0?"No parameter is called so.":e)}};var ev=500,Yl=class{constructor(t,e){this.changed=e;this.now={preset:t,table:t.table}}changed;now;past=[];future=[];gesture=null;get table(){return this.now.table}get preset(){return this.now.preset}get dirty(){return!gi(this.now.table,this.now.preset.table)}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}value(t){return jr(this.now.table,t)}differs(t){return!gi(this.value(t),jr(this.now.preset.table,t))}set(t,e,n=null){gi(this.value(t),e)||this.step({preset:this.preset,table:ha(this.now.table,t,e)},n)}remove(t){this.value(t)!==void 0&&this.step({preset:this.preset,table:yd(this.now.table,t)})}revert(t){let e=jr(this.now.preset.table,t);e===void 0?this.remove(t):this.set(t,e)}open(t,e=t.table,n){this.step({preset:t,table:e,along:n})}begin(t,e){this.now={preset:t,table:e},this.past=[],this.future=[],this.gesture=null,this.changed()}settle(){this.gesture=null}undo(){let{along:t}=this.now;this.travel(this.past,this.future)&&t?.undo()}redo(){this.travel(this.future,this.past)&&this.now.along?.redo()}step(t,e=null){(e===null||e!==this.gesture)&&this.past.push(this.now),this.past.length>ev&&this.past.shift(),this.gesture=e,this.future=[],this.now=t,this.changed()}travel(t,e){let n=t.pop();return n?(e.push(this.now),this.now=n,this.gesture=null,this.changed(),!0):!1}};var Rd=["system","light","dark"],qm="dampen-theme",nv=["displacement","rotation","uncontrolled","constraint","learned","reference","ink","faint","paper"],Zl=class{constructor(t){this.changed=t;this.system.addEventListener("change",()=>this.apply()),this.apply()}changed;system=matchMedia("(prefers-color-scheme: dark)");colours=null;get dark(){return this.theme==="system"?this.system.matches:this.theme==="dark"}get theme(){let t=iv();return Rd.find(e=>e===t)??this.unkept}set theme(t){this.unkept=t,sv(t),this.apply()}use(t){this.colours=t,this.apply()}unkept="system";apply(){let t=document.documentElement;t.dataset.theme=this.dark?"dark":"light";let e=this.colours?.[this.dark?"dark":"light"];for(let n of nv)e&&t.style.setProperty(`--${n}`,e[n]);this.changed(this.dark)}};function iv(){try{return localStorage.getItem(qm)}catch{return null}}function sv(i){try{localStorage.setItem(qm,i)}catch{}}var ro=class{element;button;panel;constructor(t,...e){this.button=N("button",{type:"button",class:"unfolds","aria-expanded":"false"},t),this.button.addEventListener("click",()=>this.toggle(this.button.getAttribute("aria-expanded")!=="true")),this.panel=N("div",{class:"menu",hidden:!0},...e),this.element=N("div",{class:"holder"},this.button,this.panel),this.element.addEventListener("keydown",n=>{n.key!=="Escape"||this.panel.hidden||(this.toggle(!1),this.button.focus())}),this.panel.addEventListener("click",n=>{n.target.closest("[data-closes]")&&this.toggle(!1)}),document.addEventListener("pointerdown",n=>{this.element.contains(n.target)||this.toggle(!1)}),this.element.addEventListener("focusout",n=>{n.relatedTarget instanceof Node&&!this.element.contains(n.relatedTarget)&&this.toggle(!1)})}toggle(t){this.panel.hidden=!t,this.button.setAttribute("aria-expanded",String(t))}};var rv=[{what:"toml",label:"Scenario (TOML)"},{what:"netcdf",label:"Result (NetCDF)"},{what:"figures",label:"Figures"},{what:"report",label:"Report"}],Jl=class{presets;other=N("option",{hidden:!0});undo;redo;pin;swap;unpin;beside;constructor(t,e,n,s){let r=(f,p,x)=>N("button",{type:"button",onclick:p,title:x},f),o=e.scenarios.map(({name:f,title:p})=>N("option",{value:f,title:p},f));this.presets=N("select",{id:"preset","aria-label":"Scenario"},this.other,...o),this.presets.addEventListener("change",()=>n.preset(this.presets.value)),this.undo=r("↶",n.undo,"Undo (Ctrl-Z)"),this.undo.setAttribute("aria-label","Undo"),this.redo=r("↷",n.redo,"Redo (Ctrl-Shift-Z)"),this.redo.setAttribute("aria-label","Redo"),this.pin=r("Pin",n.pin,"Keep this run, and draw it beside what comes"),this.swap=r("Swap",n.swap,"Work on the pinned run, and pin this one"),this.unpin=r("Unpin",n.unpin),this.beside=r("Beside no control",n.beside,"Pin the same experiment without control");let a=N("input",{type:"file",accept:".toml,.nc,.zip",hidden:!0,"aria-label":"Open a scenario or a result"});a.addEventListener("change",()=>{let[f]=a.files??[];f&&n.open(f),a.value=""});let l=(f,p)=>N("button",{type:"button","data-closes":"",onclick:p},f),c=new ro("Download",...rv.map(({what:f,label:p})=>l(p,()=>n.download(f))),l("Link",n.share)),h=N("div",{class:"tools-more",id:"tools"},N("div",{class:"set"},this.pin,this.swap,this.unpin,this.beside),N("div",{class:"set"},r("Share",n.share,"Copy a link to what you see"),c.element,r("Open…",()=>a.click()),a),ov(s)),u=N("button",{type:"button",class:"more","aria-expanded":"false","aria-controls":"tools"},"More"),d=f=>{u.setAttribute("aria-expanded",String(f)),h.classList.toggle("open",f)};u.addEventListener("click",()=>d(u.getAttribute("aria-expanded")!=="true")),document.addEventListener("keydown",f=>f.key==="Escape"&&d(!1)),t.append(this.presets,N("div",{class:"set"},this.undo,this.redo),u,h)}update({preset:t,dirty:e,canUndo:n,canRedo:s,running:r,pinned:o}){let a=[...this.presets.options].find(l=>l.value===t&&l!==this.other);this.other.hidden=a!==void 0&&!e,this.other.value=a&&!e?"":`${t}*`,this.other.textContent=e?`${t}, changed`:t,this.presets.value=a&&!e?t:this.other.value,this.undo.disabled=!n,this.redo.disabled=!s,this.pin.disabled=!r,this.beside.disabled=!r,this.swap.hidden=this.unpin.hidden=o===null,this.unpin.title=o===null?"":`Let go of: ${o}`}};function ov(i){let t=Rd.map(n=>N("option",{value:n},n==="system"?"auto":n)),e=N("select",{"aria-label":"Colours"},...t);return e.value=i.theme,e.addEventListener("change",()=>i.theme=e.value),e}var av=600,Kl=class{sentence=In("status");banner=In("banner");warnings=new ro("");verdict=N("button",{type:"button",class:"quiet",hidden:!0,onclick:()=>In("verdicts").scrollIntoView()});open=!0;message="";timer=0;constructor(){this.warnings.element.hidden=!0,this.sentence.after(this.verdict,this.warnings.element)}expect(){this.timer||=window.setTimeout(()=>this.say("Running."),av),this.verdict.classList.add("pending"),this.tell("")}withoutRun(){this.verdict.hidden=!0,this.warnings.element.hidden=!0}say(t,e=!1){clearTimeout(this.timer),this.timer=0,this.sentence.classList.toggle("bad",e),le(this.sentence,t)}picture(t){this.say(lv(t),t.status!=="complete");let{warnings:e}=t;this.warnings.element.hidden=e.length===0,le(this.warnings.button,e.length===1?"1 remark":`${e.length} remarks`),this.warnings.panel.replaceChildren(N("ul",{},...e.map(n=>N("li",{},...Un(n)))))}reviewed(t){if(this.verdict.classList.toggle("pending",t===null),t===null)return;let[e,n]=t.claims.length>0?[t.claims,"claims"]:[t.findings,"findings"],s=e.filter(({verdict:o})=>o==="PASS"||o==="FAIL"),r=s.filter(({verdict:o})=>o==="PASS").length;this.verdict.hidden=s.length===0,le(this.verdict,`${r} of ${s.length} ${n} hold`)}faults([t,...e],n){if(!t)return;let s=e.length===0?"":` And ${e.length} more.`;this.say(Dl(`${n}: ${t.at} ${t.text}${s}`.replace(/\s+/g," ")),!0)}tell(t){this.message=t,this.showBanner()}line(t){this.open=t,this.showBanner()}showBanner(){let t=this.open?this.message:"The lab has been closed; start `dampen lab` again.";this.banner.hidden=t==="",le(this.banner,t)}};function lv({status:i,trials:t,asked:e,seconds:n,source:s}){if(i==="diverged")return`The run diverged in trial ${t}, of ${e}.`;let r=`${t} ${t===1?"trial":"trials"}`;if(i==="interrupted")return`Interrupted after ${r} of ${e}.`;let o=s==="file"?`${r}, from a file`:`${r} in ${Pm(n)}`;return i==="constraint_lost"?`${o}; the constraint was lost`:o}function $m(i){let t=new DataView(i).getUint32(0,!0),e=JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,t))),n=4+t,s=r=>{let o=e.arrays[r];if(!o)throw new Error(`The frame has no array ${r}.`);return o};return{header:e,has:r=>r in e.arrays,shape:r=>s(r).shape,array:r=>{let{type:o,shape:a,at:l}=s(r),c=a.reduce((h,u)=>h*u,1);return o==="f4"?new Float32Array(i,n+l,c):new Float64Array(i,n+l,c)}}}var Ym=["now","beside"],Zm=500,cv=8e3,hv=250,jl=class{constructor(t,e){this.url=t;this.events=e;this.connect()}url;events;socket=null;retry=Zm;newest=0;unanswered=[];waiting={now:null,beside:null};timer=0;ask(t,e){let n=++this.newest;return this.waiting[t]={...e,id:n},this.send(),n}get idle(){return this.unanswered.length===0&&Ym.every(t=>this.waiting[t]===null)}connect(){let t=new WebSocket(this.url);t.binaryType="arraybuffer",t.onopen=()=>{this.socket=t,this.retry=Zm,this.events.open(!0),this.send()},t.onmessage=({data:e})=>this.receive(e),t.onclose=()=>this.lost()}lost(){this.socket=null,this.askAgain(this.unanswered.splice(0)),this.events.open(!1),setTimeout(()=>this.connect(),this.retry),this.retry=Math.min(2*this.retry,cv)}send(){clearTimeout(this.timer);let t=Ym.find(s=>this.waiting[s]!==null),e=t&&this.waiting[t];if(!this.socket||!t||!e)return;let n=this.unanswered.at(-1);if(n){if(t==="beside"&&this.unanswered.some(r=>r.lane==="now"))return;let s=n.at+hv-performance.now();if(s>0){this.timer=window.setTimeout(()=>this.send(),s);return}}this.waiting[t]=null,this.unanswered.push({lane:t,asked:e,at:performance.now()}),this.socket.send(JSON.stringify(e))}receive(t){if(typeof t=="string"){let n=JSON.parse(t);(n.say==="refused"||n.say==="failed"||n.say==="left")&&this.answered(n.id,n.say!=="left"),this.events.said(n);return}let e=$m(t);uv(e)?(this.answered(e.header.id,!0),this.events.picture(e)):this.events.detail(e)}answered(t,e){let n=this.unanswered.findIndex(({asked:s})=>s.id===t);n<0||(this.askAgain(this.unanswered.splice(0,n+1),e?t:null),this.send())}askAgain(t,e=null){for(let{lane:n,asked:s}of t){let r=[...t,...this.unanswered].some(o=>o.lane===n&&o.asked.id>s.id);s.id!==e&&!r&&(this.waiting[n]??=s)}}},uv=i=>i.header.say==="picture";function oo(i,t){let[e,n]=[0,i.length];for(;e<n;){let s=e+n>>1;i[s]<=t?e=s+1:n=s}return e-1}function _a(i,t){let e=i.length-1,n=e>0?i[e]-i[e-1]:1/0;if(!(t>=i[0]-n&&t<=i[e]+n))return-1;let s=Math.max(oo(i,t),0);return s<e&&i[s+1]-t<t-i[s]?s+1:s}var Ql=class{bytes;stops;#t;#e;#n=new Map;#i;constructor(t,e,n){this.#t=t,this.#e=e,this.#i=n;let s=e.fields[0];this.stops=s&&t.has(s.name)?n.snapshots:n.steps,this.bytes=Object.entries(t.header.arrays).filter(([r])=>!r.startsWith("all.")).reduce((r,[,{type:o,shape:a}])=>r+a.reduce((l,c)=>l*c,o==="f4"?4:8),0)}column(t,e){let n=`${t}.${e}`,s=this.#n.get(n);if(!s){let r=this.#t.array(t),o=this.#t.shape(t)[1]??1;s=o===1?r:Float32Array.from({length:r.length/o},(a,l)=>r[l*o+e]),this.#n.set(n,s)}return s}curve(t,e){return{time:xa(t)?this.#i.middles:this.#i.steps,values:this.column(t,e)}}at(t,e,n){let s=this.column(t,e),r=Math.min(Math.max(n/this.#e.step-(xa(t)?.5:0),0),s.length-1),o=Math.floor(r),a=Math.min(o+1,s.length-1),l=s[o],c=l+(r-o)*(s[a]-l);return Number.isNaN(c)?l:c}field(t){return this.#t.array(t)}shape(t,e,n){let s=this.field(t),r=Math.max(oo(this.stops,e),0),o=Math.min(r+1,this.stops.length-1),[a,l]=[e-this.stops[r],this.stops[o]-this.stops[r]],c=l>0?Math.min(Math.max(a/l,0),1):0,h=r*n.length,u=o*n.length;for(let d=0;d<n.length;d++)n[d]=s[h+d]*(1-c)+s[u+d]*c}};var dv=48e6,xa=i=>i==="command"||i==="delivered",tc=class{picture;peaks;looked=0;#t;#e;#n=new Map;#i=new Map;#s=new Map;#a=new Map;#o=0;constructor(t){this.#t=t,this.picture=t.header,this.peaks=t.array("peaks");let{steps:e,step:n}=this.picture;this.#e={steps:Float64Array.from({length:e+1},(s,r)=>r*n),middles:Float64Array.from({length:e},(s,r)=>(r+.5)*n),snapshots:Float64Array.from(t.array("time_out"))},this.looked=this.picture.trial,t.has("y")&&this.#u(this.picture.trial,t)}get ports(){return this.picture.ports}get x(){return this.#t.has("x")?this.#t.array("x"):new Float32Array(0)}add(t){this.#u(t.header.trial,t),this.#d()}has(t){return this.#n.has(t)}trial(t){return this.#n.get(t)??null}hasSignal(t){return this.#t.has(`all.${t}`)}curve(t,e,n){let s=n===null?null:this.#n.get(n);if(s)return s.curve(t,e);let[r,o]=[this.#l(t),this.overview(t,e)];if(n===null)return{time:r,values:o};let a=this.#r(t);return{time:r.subarray(0,a),values:o.subarray(n*a,(n+1)*a)}}overview(t,e){let n=`${t}.${e}`,s=this.#i.get(n);if(!s){let r=this.#t.array(`all.${t}`),o=this.#t.shape(`all.${t}`)[3]??1;s=new Float32Array(r.length/o);for(let a=0;a<s.length;a++)s[a]=r[a*o+e];this.#i.set(n,s)}return s}bounded(t,e){return this.overview(t,e).some(Number.isFinite)}largest(t,e,n){let s=`${t}.${e}.${n}`,r=this.#s.get(s);if(r===void 0){let o=this.#r(t),a=this.overview(t,e);r=Jm(n===null?a:a.subarray(n*o,(n+1)*o)),this.#s.set(s,r)}return r}field(t,e){let n=e===null?null:this.#n.get(e);if(n)return{values:n.field(t),time:this.#e.snapshots};let[,s=0]=this.#t.shape(`all.${t}`),[r,o]=[this.#c(s),this.#t.array(`all.${t}`)];if(e===null)return{values:o,time:r};let a=s*this.x.length;return{values:o.subarray(e*a,(e+1)*a),time:r.subarray(0,s)}}largestOfField(t,e){let n=`field ${t}.${e}`,s=this.#s.get(n);if(s===void 0){let[,r=0]=this.#t.shape(`all.${t}`),o=this.#t.array(`all.${t}`),a=r*this.x.length;s=Jm(e===null?o:o.subarray(e*a,(e+1)*a)),this.#s.set(n,s)}return s}peak(t,e){return this.peaks[t*this.ports.length+e]??NaN}#r(t){return 2*(this.#t.shape(`all.${t}`)[1]??0)}#l(t){let{duration:e,step:n}=this.picture,s=this.#r(t);return this.#h(`${xa(t)}.${s}`,()=>{let r=this.#t.array("time"),o=r.length>1?(r[1]-r[0])/4:1/0;return Float64Array.from({length:s},(a,l)=>{let c=Math.min(r[l>>1]+(xa(t)?n/2:0),e),h=Math.min(o,(e-c)/2);return l%2===0?c-h:c+h})})}#c(t){let{snapshots:e}=this.#e,n=Math.ceil(e.length/t);return this.#h(`columns.${t}`,()=>Float64Array.from({length:t},(s,r)=>{let o=Math.min((r+1)*n,e.length)-1;return(e[r*n]+e[o])/2}))}#h(t,e){let n=this.#a.get(t);if(!n){let[s,{trials:r,duration:o}]=[e(),this.picture];n=Float64Array.from({length:r*s.length},(a,l)=>Math.floor(l/s.length)*o+s[l%s.length]),this.#a.set(t,n)}return n}#u(t,e){let n=new Ql(e,this.picture,this.#e);this.#o+=n.bytes-(this.#n.get(t)?.bytes??0),this.#n.set(t,n)}#d(){for(;this.#o>dv&&this.#n.size>1;){let t=[...this.#n.keys()].reduce((e,n)=>Math.abs(n-this.looked)>Math.abs(e-this.looked)?n:e);this.#o-=this.#n.get(t)?.bytes??0,this.#n.delete(t)}}};function Jm(i){let t=0;for(let e=0;e<i.length;e++){let n=Math.abs(i[e]);n>t&&n<1/0&&(t=n)}return t}var fv=400,ec=class{constructor(t,e){this.view=t;this.events=e;let n=location.protocol==="https:"?"wss":"ws";this.connection=new jl(`${n}://${location.host}/ws`,{picture:s=>{this.picture(s)},detail:s=>this.detail(s),said:s=>this.said(s),open:s=>this.line(s)})}view;events;now=null;pinned=null;connection;asked=new Map;timer=0;newest=0;run(t){return this.view.stand("coming"),this.newest=this.ask({lane:"now",source:t,missing:null}),this.newest}runBeside(t){this.ask({lane:"beside",source:t,missing:null})}pin(t){this.pinned=t,this.view.pin(t?.run??null,t?.source.label??""),this.events.pinned(t?.source.label??null),this.soon()}look(t){let{now:e,pinned:n}=this;e&&t<e.run.picture.trials&&!e.run.has(t)&&this.refill("now",e),n&&n!==e&&t<n.run.picture.trials&&!n.run.has(t)&&this.refill("beside",n)}ask(t){let{table:e,token:n}=t.source,{trial:s}=this.view.state,r=n===void 0?{do:"run",table:e,trial:s}:{do:"open",token:n,trial:s},o=this.connection.ask(t.lane,r);return this.asked.set(o,t),this.soon(),o}refill(t,e){e.id=this.ask({lane:t,source:e.source,missing:e}),e.details="coming"}async picture(t){let{id:e}=t.header,n=this.asked.get(e);if(!n)return;if(this.forget(e,n.lane),n.missing){this.add(n.missing.run,pv(t));return}let s={source:n.source,run:new tc(t),id:e,details:"coming"};if(n.lane==="beside"){this.pin(s);return}this.now=s,this.review(null),await this.view.show(s.run,s.source.label,e===this.newest?"own":"coming"),this.now===s&&e===this.newest&&this.events.drawn(t.header),nc("dampen:drawn",e)}detail(t){for(let{run:e}of this.showing(t.header.id))this.add(e,t)}add(t,e){t.add(e),this.view.more(t)}said(t){switch(t.say){case"note":this.events.note(t.text);break;case"refused":this.concerns(t.id)&&this.events.refused(t.faults);break;case"failed":this.concerns(t.id)&&this.events.failed(t.text);break;case"review":if(this.now?.id!==t.id)break;this.review(t),nc("dampen:review",t.id);break;case"complete":case"left":for(let e of this.showing(t.id))e.details=t.say;this.soon();break}}review(t){this.view.review(t),this.events.reviewed(t)}concerns(t){let e=this.asked.get(t);return e&&this.forget(t,e.lane),e?.missing&&(e.missing.details="complete"),e&&t===this.newest&&(this.view.stand("other"),this.events.without()),e?.lane==="beside"||t===0||t>=this.newest}forget(t,e){for(let[n,s]of this.asked)n<=t&&s.lane===e&&this.asked.delete(n)}line(t){for(let e of[this.now,this.pinned])!t&&e?.details==="coming"&&(e.details="left");this.asked.has(this.newest)&&this.view.stand(t?"coming":"other"),t&&this.soon(),this.events.line(t)}showing(t){let{now:e,pinned:n}=this;return[e,n===e?null:n].filter(s=>s?.id===t)}soon(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{let{now:t,pinned:e}=this;this.connection.idle&&(t?.details==="left"?this.refill("now",t):t?.details!=="coming"&&e?.details==="left"&&this.refill("beside",e))},fv)}};function pv(i){let{id:t,trial:e,arrays:n}=i.header;return{header:{say:"trial",id:t,trial:e,arrays:n},array:s=>i.array(s),shape:s=>i.shape(s),has:s=>i.has(s)}}var nc=(i,t)=>window.dispatchEvent(new CustomEvent(i,{detail:{id:t}}));function Km({compensation:i,numerics:t,...e}){let n=De(t)?{numerics:{...t,mode:"continuous"}}:{};return{...e,...n,controller:{kind:"none"}}}function Cd(i,t,e,n){let s=e*n,r=(i.trial*n+i.time+t)%s,o=Math.min(Math.floor(r/n),e-1);return{trial:o,time:Math.min(Math.max(r-o*n,0),n)}}function jm(i,t,e){let n=Math.min(Math.max(Math.floor(i/e),0),t-1);return{trial:n,time:Math.min(Math.max(i-n*e,0),e)}}var mv=["ink","faint","paper","card","line","displacement","rotation","uncontrolled","constraint","learned","reference"],gv={card:"paper",line:"faint"},ic=class{dark=!1;#t=new Map;constructor(){this.read(document.documentElement.dataset.theme==="dark")}read(t){this.dark=t;let e=getComputedStyle(document.documentElement);for(let n of mv)this.#t.set(n,e.getPropertyValue(`--${n}`).trim())}colour(t){return this.#t.get(t)||this.#t.get(gv[t]??"ink")||"#808080"}},Qm=[[],[7,3],[2,2],[7,2,2,2]],tg=["disc","square","diamond","triangle"];function Yi(i,t){let e=i[t].motion_unit,n=i.slice(0,t).filter(s=>s.motion_unit===e).length;return{token:e==="m"?"displacement":e==="rad"?"rotation":"ink",dash:Qm[n%Qm.length],marker:tg[t%tg.length]}}function xr(i){let t=i.motion_unit==="m"?"displacement":i.motion_unit==="rad"?"rotation":"motion";return`${eg(i)} ${t}`}function vr(i){return`${eg(i)} ${i.kind}`}function eg(i){return i.name.replace(/_(w|phi|theta|y)$/,"").replaceAll("_"," ")}function va(i){return ao(i.symbol)}function ao(i){return i.replaceAll("phi","φ").replaceAll("theta","θ")}function ps(i){return i.charAt(0).toUpperCase()+i.slice(1)}var yv=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],_v="⁰¹²³⁴⁵⁶⁷⁸⁹";function sc(i){return/^-0(\.0*)?$/.test(i)?i.slice(1):i.replace("-","−")}function Pd(i){let t=[...String(Math.abs(i))].map(e=>_v[Number(e)]).join("");return`10${i<0?"⁻":""}${t}`}function Ri(i,t=3){if(!Number.isFinite(i))return Number.isNaN(i)?"–":i>0?"∞":"−∞";if(i===0)return"0";let e=Math.floor(Math.log10(Math.abs(i)));return e<-4||e>5?`${sc((i/10**e).toFixed(Math.max(0,t-1)))} · ${Pd(e)}`:sc(i.toFixed(Math.max(0,t-1-e)))}var Je=class{unit;factor;decimals;constructor(t,e){let n=Math.abs(t),s=n>0&&n<1/0&&e!=="",[r,o]=s&&yv.find(([l])=>n>=l*.9995)||[1,""];this.factor=r,this.unit=o+e;let a=n/r;this.decimals=a>0&&a<1/0?Math.min(6,Math.max(0,2-Math.floor(Math.log10(a)))):0}number(t){return Number.isFinite(t)?sc((t/this.factor).toFixed(this.decimals)):Ri(t)}text(t){return`${this.number(t)} ${this.unit}`}};function ba(i,t){return new Je(i,t).text(i)}function Id(i,t){let e=i.length>1?Math.abs(i[1]-i[0])/t:1,n=0;for(;n<8&&Math.abs(e*10**n-Math.round(e*10**n))>1e-6;)n++;return i.map(s=>sc((s/t).toFixed(n)))}function ng(i){let t=i.map(ig);return t.filter(Boolean).length<2?i:i.map((e,n)=>t[n]?e:null)}function ig(i){return Math.abs(Math.log10(i)-Math.round(Math.log10(i)))<1e-9}function sg(i){let t=i.map(ig),e=t.filter(Boolean).length<2;return i.map((n,s)=>{if(t[s])return Pd(Math.round(Math.log10(n)));let r=Math.round(n/10**Math.floor(Math.log10(n)));return e&&(r===2||r===5)?`${r} · ${Pd(Math.floor(Math.log10(n)))}`:""})}var xv="uplot",vv="u-hz",bv="u-vt",Sv="u-title",Mv="u-wrap",wv="u-under",Tv="u-over",Ev="u-axis",Mr="u-off",Av="u-select",Rv="u-cursor-x",Cv="u-cursor-y",Pv="u-cursor-pt",Iv="u-legend",Lv="u-live",Dv="u-inline",Nv="u-series",Fv="u-marker",rg="u-label",Uv="u-value",Ma="width",wa="height";var og="bottom",lo="left",Ld="right",Zd="#000",ag=Zd+"0",Dd="mousemove",lg="mousedown",Nd="mouseup",cg="mouseenter",hg="mouseleave",ug="dblclick",Ov="resize",kv="scroll",dg="change",cc="dppxchange",Jd="--",go=typeof window<"u",Bd=go?document:null,ho=go?window:null,Bv=go?navigator:null,Me,rc;function zd(){let i=devicePixelRatio;Me!=i&&(Me=i,rc&&Vd(dg,rc,zd),rc=matchMedia(`(min-resolution: ${Me-.001}dppx) and (max-resolution: ${Me+.001}dppx)`),wr(dg,rc,zd),ho.dispatchEvent(new CustomEvent(cc)))}function si(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Hd(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ge(i,t,e){i.style[t]=e+"px"}function Ci(i,t,e,n){let s=Bd.createElement(i);return t!=null&&si(s,t),e?.insertBefore(s,n),s}function yi(i,t){return Ci("div",i,t)}var fg=new WeakMap;function Zi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=fg.get(i);r!=o&&(i.style.transform=r,fg.set(i,r),t<0||e<0||t>n||e>s?si(i,Mr):Hd(i,Mr))}var pg=new WeakMap;function mg(i,t,e){let n=t+e,s=pg.get(i);n!=s&&(pg.set(i,n),i.style.background=t,i.style.borderColor=e)}var gg=new WeakMap;function yg(i,t,e,n){let s=t+""+e,r=gg.get(i);s!=r&&(gg.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Kd={passive:!0},zv={...Kd,capture:!0};function wr(i,t,e,n){t.addEventListener(i,e,n?zv:Kd)}function Vd(i,t,e,n){t.removeEventListener(i,e,Kd)}go&&zd();function Pi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ri((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Xg(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var qg=i=>i!=null,$g=i=>i!=null&&i>0,dc=Xg(qg),Hv=Xg($g);function Vv(i,t,e,n=0,s=!1){let r=s?Hv:dc,o=s?$g:qg;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ne,l??-Ne]}function fc(i,t,e,n){let s=vg(i),r=vg(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ms:Yg,a=s==1?ri:_i,l=r==1?_i:ri,c=a(o(xn(i))),h=l(o(xn(t))),u=uo(e,c),d=uo(e,h);return e==10&&(c<0&&(u=Fe(u,-c)),h<0&&(d=Fe(d,-h))),n||e==2?(i=u*s,t=d*r):(i=jg(i,u),t=pc(t,d)),[i,t]}function jd(i,t,e,n){let s=fc(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Qd=.1,_g={mode:3,pad:Qd},Ea={pad:0,soft:null,mode:0},Gv={min:Ea,max:Ea};function hc(i,t,e,n){return mc(e)?xg(i,t,e):(Ea.pad=e,Ea.soft=n?0:null,Ea.mode=n?3:0,xg(i,t,Gv))}function be(i,t){return i??t}function Wv(i,t,e){for(t=be(t,0),e=be(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function xg(i,t,e){let n=e.min,s=e.max,r=be(n.pad,0),o=be(s.pad,0),a=be(n.hard,-Ne),l=be(s.hard,Ne),c=be(n.soft,Ne),h=be(s.soft,-Ne),u=be(n.mode,0),d=be(s.mode,0),f=t-i,p=ms(f),x=qn(xn(i),xn(t)),m=ms(x),g=xn(m-p);(f<1e-24||g>10)&&(f=0,(i==0||t==0)&&(f=1e-24,u==2&&c!=Ne&&(r=0),d==2&&h!=-Ne&&(o=0)));let v=f||x||1e3,A=ms(v),S=uo(10,ri(A)),C=v*(f==0?i==0?.1:1:r),E=Fe(jg(i-C,S/10),24),_=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Ne,T=qn(a,E<_&&i>=_?_:Ii(_,E)),k=v*(f==0?t==0?.1:1:o),F=Fe(pc(t+k,S/10),24),D=t<=h&&(d==1||d==3&&F>=h||d==2&&F<=h)?h:-Ne,H=Ii(l,F>D&&t<=D?D:qn(D,F));return T==H&&T==0&&(H=100),[T,H]}var Xv=new Intl.NumberFormat(go?Bv.language:"en-US"),tf=i=>Xv.format(i),oi=Math,lc=oi.PI,xn=oi.abs,ri=oi.floor,_n=oi.round,_i=oi.ceil,Ii=oi.min,qn=oi.max,uo=oi.pow,vg=oi.sign,ms=oi.log10,Yg=oi.log2,qv=(i,t=1)=>oi.sinh(i)*t,Fd=(i,t=1)=>oi.asinh(i/t),Ne=1/0;function bg(i){return(ms((i^i>>31)-(i>>31))|0)+1}function Gd(i,t,e){return Ii(qn(i,t),e)}function Zg(i){return typeof i=="function"}function ye(i){return Zg(i)?i:()=>i}var $v=()=>{},Jg=i=>i,Kg=(i,t)=>t,Yv=i=>null,Sg=i=>!0,Mg=(i,t)=>i==t,Zv=/\.\d*?(?=9{6,}|0{6,})/gm,Tr=i=>{if(t0(i)||Xs.has(i))return i;let t=`${i}`,e=t.match(Zv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Tr(s)}e${r}`}return Fe(i,n)};function br(i,t){return Tr(Fe(Tr(i/t))*t)}function pc(i,t){return Tr(_i(Tr(i/t))*t)}function jg(i,t){return Tr(ri(Tr(i/t))*t)}function Fe(i,t=0){if(t0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return _n(n)/e}var Xs=new Map;function Qg(i){return((""+i).split(".")[1]||"").length}function Ra(i,t,e,n){let s=[],r=n.map(Qg);for(let o=t;o<e;o++){let a=xn(o),l=Fe(uo(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Fe(h,u);s.push(d),Xs.set(d,u)}}return s}var Aa={},ef=[],fo=[null,null],Ws=Array.isArray,t0=Number.isInteger,Jv=i=>i===void 0;function wg(i){return typeof i=="string"}function mc(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Kv(i){return i!=null&&typeof i=="object"}var jv=Object.getPrototypeOf(Uint8Array),e0="__proto__";function po(i,t=mc){let e;if(Ws(i)){let n=i.find(s=>s!=null);if(Ws(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=po(i[s],t)}else e=i.slice()}else if(i instanceof jv)e=i.slice();else if(t(i)){e={};for(let n in i)n!=e0&&(e[n]=po(i[n],t))}else e=i;return e}function fn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=e0&&(mc(i[s])?fn(i[s],po(n[s])):i[s]=po(n[s]))}return i}var Qv=0,tb=1,eb=2;function nb(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function ib(i,t){if(ob(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return ab(o[0])||(o=rb(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:tb,f=[];for(let p=0;p<h.length;p++){let x=h[p],m=r.get(l[p]);x===null?d!=Qv&&(u[m]=x,d==eb&&f.push(m)):u[m]=x}nb(u,f,s),n.push(u)}}return n}var sb=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function rb(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function ob(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function ab(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=qn(1,ri((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var n0=["January","February","March","April","May","June","July","August","September","October","November","December"],i0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function s0(i){return i.slice(0,3)}var lb=i0.map(s0),cb=n0.map(s0),hb={MMMM:n0,MMM:cb,WWWW:i0,WWW:lb};function Sa(i){return(i<10?"0":"")+i}function ub(i){return(i<10?"00":i<100?"0":"")+i}var db={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Sa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Sa(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Sa(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Sa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Sa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>ub(i.getMilliseconds())};function nf(i,t){t=t||hb;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?db[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var fb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function pb(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==fb?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var r0=i=>i%1==0,uc=[1,2,2.5,5],mb=Ra(10,-32,0,uc),o0=Ra(10,0,32,uc),gb=o0.filter(r0),Sr=mb.concat(o0),sf=`
`,a0="{YYYY}",Tg=sf+a0,l0="{M}/{D}",Ta=sf+l0,oc=Ta+"/{YY}",c0="{aa}",yb="{h}:{mm}",co=yb+c0,Eg=sf+co,Ag=":{ss}",Te=null;function h0(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ra(10,0,3,uc).filter(r0):Ra(10,-3,0,uc)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,a0,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",Tg,Te,Te,Te,Te,Te,1],[s,l0,Tg,Te,Te,Te,Te,Te,1],[n,"{h}"+c0,oc,Te,Ta,Te,Te,Te,1],[e,co,oc,Te,Ta,Te,Te,Te,1],[t,Ag,oc+" "+co,Te,Ta+" "+co,Te,Eg,Te,1],[i,Ag+".{fff}",oc+" "+co,Te,Ta+" "+co,Te,Eg,Te,1]];function h(u){return(d,f,p,x,m,g)=>{let v=[],A=m>=o,S=m>=r&&m<o,C=u(p),E=Fe(C*i,3),_=Ud(C.getFullYear(),A?0:C.getMonth(),S||A?1:C.getDate()),T=Fe(_*i,3);if(S||A){let k=S?m/r:0,F=A?m/o:0,D=E==T?E:Fe(Ud(_.getFullYear()+F,_.getMonth()+k,1)*i,3),H=new Date(_n(D/i)),W=H.getFullYear(),L=H.getMonth();for(let X=0;D<=x;X++){let Y=Ud(W+F*X,L+k*X,1),G=Y-u(Fe(Y*i,3));D=Fe((+Y+G)*i,3),D<=x&&v.push(D)}}else{let k=m>=s?s:m,F=ri(p)-ri(E),D=T+F+pc(E-T,k);v.push(D);let H=u(D),W=H.getHours()+H.getMinutes()/e+H.getSeconds()/n,L=m/n,X=d.axes[f]._space,Y=g/X;for(;D=Fe(D+m,i==1?0:3),!(D>x);)if(L>1){let G=ri(Fe(W+L,6))%24,Q=u(D).getHours()-G;Q>1&&(Q=-1),D-=Q*n,W=(W+L)%24;let st=v[v.length-1];Fe((D-st)/m,3)*Y>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[_b,xb,vb]=h0(1),[bb,Sb,Mb]=h0(.001);Ra(2,-53,53,[1]);function Rg(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Cg(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,d,f;return n.map(p=>{let x=i(p),m=x.getFullYear(),g=x.getMonth(),v=x.getDate(),A=x.getHours(),S=x.getMinutes(),C=x.getSeconds(),E=m!=l&&a[2]||g!=c&&a[3]||v!=h&&a[4]||A!=u&&a[5]||S!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,c=g,h=v,u=A,d=S,f=C,E(x)})}}function wb(i,t){let e=nf(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Ud(i,t,e){return new Date(i,t,e)}function Pg(i,t){return t(i)}var Tb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ig(i,t){return(e,n,s,r)=>r==null?Jd:t(i(n))}function Eb(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Ab(i,t){return i.series[t].fill(i,t)}var Rb={show:!0,live:!0,isolate:!1,mount:$v,markers:{show:!0,width:2,stroke:Eb,fill:Ab,dash:"solid"},idx:null,idxs:null,values:[]};function Cb(i,t){let e=i.cursor.points,n=yi(),s=e.size(i,t);Ge(n,Ma,s),Ge(n,wa,s);let r=s/-2;Ge(n,"marginLeft",r),Ge(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ge(n,"borderWidth",o),n}function Pb(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Ib(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Lb(i,t){return i.series[t].points.size}var Od=[0,0];function Db(i,t,e){return Od[0]=t,Od[1]=e,Od}function ac(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function kd(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var Nb={show:!0,x:!0,y:!0,lock:!1,move:Db,points:{one:!1,show:Cb,size:Lb,width:0,stroke:Ib,fill:Pb},bind:{mousedown:ac,mouseup:ac,click:ac,dblclick:ac,mousemove:kd,mouseleave:kd,mouseenter:kd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},u0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},rf=fn({},u0,{filter:Kg}),d0=fn({},rf,{size:10}),f0=fn({},u0,{show:!1}),of='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',p0="bold "+of,m0=1.5,Lg={show:!0,scale:"x",stroke:Zd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:p0,side:2,grid:rf,ticks:d0,border:f0,font:of,lineGap:m0,rotate:0},Fb="Value",Ub="Time",Dg={show:!0,scale:"x",auto:!1,sorted:1,min:Ne,max:-Ne,idxs:[]};function Ob(i,t,e,n,s){return t.map(r=>r==null?"":tf(r))}function kb(i,t,e,n,s,r,o){let a=[],l=Xs.get(s)||0;e=o?e:Fe(pc(e,s),l);for(let c=e;c<=n;c=Fe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Wd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?ms:Yg,h=ri(c(e));s=uo(l,h),l==10&&(s=Sr[Pi(s,Sr)]);let u=e,d=s*l;l==10&&(d=Sr[Pi(d,Sr)]);do a.push(u),u=u+s,l==10&&!Xs.has(u)&&(u=Fe(u,Xs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Sr[Pi(d,Sr)]));while(u<=n);return a}function Bb(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Wd(i,t,qn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Wd(i,t,qn(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var g0=/./,zb=/[12357]/,Hb=/[125]/,Ng=/1/,Xd=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Vb(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?g0:l(7,o)-h>=c?zb:l(5,o)-h>=c?Hb:Ng;if(u==Ng){let d=xn(l(1,o)-h);if(d<c)return Xd(t.slice().reverse(),a.distr,u,_i(c/d)).reverse()}return Xd(t,a.distr,u,1)}function Gb(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=xn(l(1,o)-l(2,o));return c<a?Xd(t.slice().reverse(),3,g0,_i(a/c)).reverse():t}function Wb(i,t,e,n){return n==null?Jd:t==null?"":tf(t)}var Fg={show:!0,scale:"y",stroke:Zd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:p0,side:3,grid:rf,ticks:d0,border:f0,font:of,lineGap:m0,rotate:0};function Xb(i,t){let e=3+(i||1)*2;return Fe(e*t,3)}function qb(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=xn(o-r),l=i.series[t],c=a/(l.points.space*Me);return n[1]-n[0]<=c}var Ug={scale:null,auto:!0,sorted:0,min:Ne,max:-Ne},y0=(i,t,e,n,s)=>s,Og={show:!0,auto:!0,sorted:0,gaps:y0,alpha:1,facets:[fn({},Ug,{scale:"x"}),fn({},Ug,{scale:"y"})]},kg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:y0,alpha:1,points:{show:qb,filter:null},values:null,min:Ne,max:-Ne,idxs:[],path:null,clip:null};function $b(i,t,e,n,s){return e/10}var _0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Yb=fn({},_0,{time:!1,ori:1}),Bg={};function x0(i,t){let e=Bg[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Bg[i]=e)),e}var mo=1,qd=2;function Er(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,m=i.valToPosH,g=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,g,d,f,p,x,yc,yo,xc,b0,M0):e(s,l,c,h,u,g,m,f,d,x,p,_c,_o,cf,S0,w0)}function af(i,t){let e=0,n=0,s=be(i.bands,ef);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Zb(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gs(i,t,e,n,s,r){return Er(i,t,(o,a,l,c,h,u,d,f,p,x,m)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?yo:_o,S,C;v==1?(S=e,C=n):(S=n,C=e);let E=g(u(a[S],c,x,f)),_=g(d(l[S],h,m,p)),T=g(u(a[C],c,x,f)),k=g(d(r==1?h.max:h.min,h,m,p)),F=new Path2D(s);return A(F,T,k),A(F,E,k),A(F,E,_),F})}function gc(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?xc:cf,l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Jb(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function lf(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),x=u-s;f=o<=0&&x>=0&&x<l?r(i[x]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(i[g]):p,p>=f&&a.push([f,p])}return a}function zg(i){return i==0?Jg:i==1?_n:t=>br(t,i)}function v0(i){let t=i==0?yc:_c,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ii(c,a/2,l/2),h=Ii(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var yc=(i,t,e)=>{i.moveTo(t,e)},_c=(i,t,e)=>{i.moveTo(e,t)},yo=(i,t,e)=>{i.lineTo(t,e)},_o=(i,t,e)=>{i.lineTo(e,t)},xc=v0(0),cf=v0(1),b0=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},S0=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},M0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},w0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function T0(i){return(t,e,n,s,r)=>Er(t,e,(o,a,l,c,h,u,d,f,p,x,m)=>{let{pxRound:g,points:v}=o,A,S;c.ori==0?(A=yc,S=b0):(A=_c,S=S0);let C=Fe(v.width*Me,3),E=(v.size-v.width)/2*Me,_=Fe(E*2,3),T=new Path2D,k=new Path2D,{left:F,top:D,width:H,height:W}=t.bbox;xc(k,F-_,D-_,H+_*2,W+_*2);let L=X=>{if(l[X]!=null){let Y=g(u(a[X],c,x,f)),G=g(d(l[X],h,m,p));A(T,Y+E,G),S(T,Y,G,E,0,lc*2)}};if(r)r.forEach(L);else for(let X=n;X<=s;X++)L(X);return{stroke:C>0?T:null,fill:T,clip:k,flags:mo|qd}})}function E0(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Kb=E0(yo),jb=E0(_o);function A0(i){let t=be(i?.alignGaps,0);return(e,n,s,r)=>Er(e,n,(o,a,l,c,h,u,d,f,p,x,m)=>{[s,r]=dc(l,s,r);let g=o.pxRound,v=W=>g(u(W,c,x,f)),A=W=>g(d(W,h,m,p)),S,C;c.ori==0?(S=yo,C=Kb):(S=_o,C=jb);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mo},T=_.stroke,k=!1;if(r-s>=x*4){let W=ut=>e.posToVal(ut,c.key,!0),L=null,X=null,Y,G,ct,K=v(a[E==1?s:r]),Q=v(a[s]),st=v(a[r]),dt=W(E==1?Q+1:st-1);for(let ut=E==1?s:r;ut>=s&&ut<=r;ut+=E){let tt=a[ut],_t=(E==1?tt<dt:tt>dt)?K:v(tt),At=l[ut];_t==K?At!=null?(G=At,L==null?(S(T,_t,A(G)),Y=L=X=G):G<L?L=G:G>X&&(X=G)):At===null&&(k=!0):(L!=null&&C(T,K,A(L),A(X),A(Y),A(G)),At!=null?(G=At,S(T,_t,A(G)),L=X=Y=G):(L=X=null,At===null&&(k=!0)),K=_t,dt=W(K+E))}L!=null&&L!=X&&ct!=K&&C(T,K,A(L),A(X),A(Y),A(G))}else for(let W=E==1?s:r;W>=s&&W<=r;W+=E){let L=l[W];L===null?k=!0:L!=null&&S(T,v(a[W]),A(L))}let[D,H]=af(e,n);if(o.fill!=null||D!=0){let W=_.fill=new Path2D(T),L=o.fillTo(e,n,o.min,o.max,D),X=A(L),Y=v(a[s]),G=v(a[r]);E==-1&&([G,Y]=[Y,G]),S(W,G,X),S(W,Y,X)}if(!o.spanGaps){let W=[];k&&W.push(...lf(a,l,s,r,E,v,t)),_.gaps=W=o.gaps(e,n,s,r,W),_.clip=gc(W,c.ori,f,p,x,m)}return H!=0&&(_.band=H==2?[gs(e,n,s,r,T,-1),gs(e,n,s,r,T,1)]:gs(e,n,s,r,T,H)),_})}function Qb(i){let t=be(i.align,1),e=be(i.ascDesc,!1),n=be(i.alignGaps,0),s=be(i.extend,!1);return(r,o,a,l)=>Er(r,o,(c,h,u,d,f,p,x,m,g,v,A)=>{[a,l]=dc(u,a,l);let S=c.pxRound,{left:C,width:E}=r.bbox,_=Q=>S(p(Q,d,v,m)),T=Q=>S(x(Q,f,A,g)),k=d.ori==0?yo:_o,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:mo},D=F.stroke,H=d.dir*(d.ori==0?1:-1),W=T(u[H==1?a:l]),L=_(h[H==1?a:l]),X=L,Y=L;s&&t==-1&&(Y=C,k(D,Y,W)),k(D,L,W);for(let Q=H==1?a:l;Q>=a&&Q<=l;Q+=H){let st=u[Q];if(st==null)continue;let dt=_(h[Q]),ut=T(st);t==1?k(D,dt,W):k(D,X,ut),k(D,dt,ut),W=ut,X=dt}let G=X;s&&t==1&&(G=C+E,k(D,G,W));let[ct,K]=af(r,o);if(c.fill!=null||ct!=0){let Q=F.fill=new Path2D(D),st=c.fillTo(r,o,c.min,c.max,ct),dt=T(st);k(Q,G,dt),k(Q,Y,dt)}if(!c.spanGaps){let Q=[];Q.push(...lf(h,u,a,l,H,_,n));let st=c.width*Me/2,dt=e||t==1?st:-st,ut=e||t==-1?-st:st;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ut}),F.gaps=Q=c.gaps(r,o,a,l,Q),F.clip=gc(Q,d.ori,m,g,v,A)}return K!=0&&(F.band=K==2?[gs(r,o,a,l,D,-1),gs(r,o,a,l,D,1)]:gs(r,o,a,l,D,K)),F})}function Hg(i,t,e,n,s,r,o=Ne){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=xn(i[l]-i[a]);h<c&&(c=h,o=xn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function tS(i){i=i||Aa;let t=be(i.size,[.6,Ne,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ye(s),o=1-t[0],a=be(t[1],Ne),l=be(t[2],1),c=be(i.disp,Aa),h=be(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,x,m)=>Er(f,p,(g,v,A,S,C,E,_,T,k,F,D)=>{let H=g.pxRound,W=e,L=n*Me,X=a*Me,Y=l*Me,G,ct;S.ori==0?[G,ct]=r(f,p):[ct,G]=r(f,p);let K=S.dir*(S.ori==0?1:-1),Q=S.ori==0?xc:cf,st=S.ori==0?h:(Ct,Yt,se,Mt,Le,Ht,qt)=>{h(Ct,Yt,se,Le,Mt,qt,Ht)},dt=be(f.bands,ef).find(Ct=>Ct.series[0]==p),ut=dt!=null?dt.dir:0,tt=g.fillTo(f,p,g.min,g.max,ut),mt=H(_(tt,C,D,k)),_t,At,St,Wt=F,ie=H(g.width*Me),Vt=!1,de=null,oe=null,ee=null,qe=null;u!=null&&(ie==0||d!=null)&&(Vt=!0,de=u.values(f,p,x,m),oe=new Map,new Set(de).forEach(Ct=>{Ct!=null&&oe.set(Ct,new Path2D)}),ie>0&&(ee=d.values(f,p,x,m),qe=new Map,new Set(ee).forEach(Ct=>{Ct!=null&&qe.set(Ct,new Path2D)})));let{x0:Ue,size:an}=c;if(Ue!=null&&an!=null){W=1,v=Ue.values(f,p,x,m),Ue.unit==2&&(v=v.map(se=>f.posToVal(T+se*F,S.key,!0)));let Ct=an.values(f,p,x,m);an.unit==2?At=Ct[0]*F:At=E(Ct[0],S,F,T)-E(0,S,F,T),Wt=Hg(v,A,E,S,F,T,Wt),St=Wt-At+L}else Wt=Hg(v,A,E,S,F,T,Wt),St=Wt*o+L,At=Wt-St;St<1&&(St=0),ie>=At/2&&(ie=0),St<5&&(H=Jg);let Pe=St>0,Mn=Wt-St-(Pe?ie:0);At=H(Gd(Mn,Y,X)),_t=(W==0?At/2:W==K?0:At)-W*K*((W==0?L/2:0)+(Pe?ie/2:0));let xe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},mn=Vt?null:new Path2D,Qe=null;if(dt!=null)Qe=f.data[dt.series[1]];else{let{y0:Ct,y1:Yt}=c;Ct!=null&&Yt!=null&&(A=Yt.values(f,p,x,m),Qe=Ct.values(f,p,x,m))}let ln=G*At,O=ct*At;for(let Ct=K==1?x:m;Ct>=x&&Ct<=m;Ct+=K){let Yt=A[Ct];if(Yt==null)continue;if(Qe!=null){let q=Qe[Ct]??0;if(Yt-q==0)continue;mt=_(q,C,D,k)}let se=S.distr!=2||c!=null?v[Ct]:Ct,Mt=E(se,S,F,T),Le=_(be(Yt,tt),C,D,k),Ht=H(Mt-_t),qt=H(qn(Le,mt)),R=H(Ii(Le,mt)),b=qt-R;if(Yt!=null){let q=Yt<0?O:ln,ht=Yt<0?ln:O;Vt?(ie>0&&ee[Ct]!=null&&Q(qe.get(ee[Ct]),Ht,R+ri(ie/2),At,qn(0,b-ie),q,ht),de[Ct]!=null&&Q(oe.get(de[Ct]),Ht,R+ri(ie/2),At,qn(0,b-ie),q,ht)):Q(mn,Ht,R+ri(ie/2),At,qn(0,b-ie),q,ht),st(f,p,Ct,Ht-ie/2,R,At+ie,b)}}return ie>0?xe.stroke=Vt?qe:mn:Vt||(xe._fill=g.width==0?g._fill:g._stroke??g._fill,xe.width=0),xe.fill=Vt?oe:mn,xe})}function eS(i,t){let e=be(t?.alignGaps,0);return(n,s,r,o)=>Er(n,s,(a,l,c,h,u,d,f,p,x,m,g)=>{[r,o]=dc(c,r,o);let v=a.pxRound,A=G=>v(d(G,h,m,p)),S=G=>v(f(G,u,g,x)),C,E,_;h.ori==0?(C=yc,_=yo,E=M0):(C=_c,_=_o,E=w0);let T=h.dir*(h.ori==0?1:-1),k=A(l[T==1?r:o]),F=k,D=[],H=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let K=l[G],Q=A(K);D.push(F=Q),H.push(S(c[G]))}let W={stroke:i(D,H,C,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:mo},L=W.stroke,[X,Y]=af(n,s);if(a.fill!=null||X!=0){let G=W.fill=new Path2D(L),ct=a.fillTo(n,s,a.min,a.max,X),K=S(ct);_(G,F,K),_(G,k,K)}if(!a.spanGaps){let G=[];G.push(...lf(l,c,r,o,T,A,e)),W.gaps=G=a.gaps(n,s,r,o,G),W.clip=gc(G,h.ori,p,x,m,g)}return Y!=0&&(W.band=Y==2?[gs(n,s,r,o,L,-1),gs(n,s,r,o,L,1)]:gs(n,s,r,o,L,Y)),W})}function nS(i){return eS(iS,i)}function iS(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}var $d=new Set;function Vg(){for(let i of $d)i.syncRect(!0)}go&&(wr(Ov,ho,Vg),wr(kv,ho,Vg,!0),wr(cc,ho,()=>{Dn.pxRatio=Me}));var sS=A0(),rS=T0();function Gg(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Yd(r,o,t,e))}function oS(i,t){return i.map((e,n)=>n==0?{}:fn({},t,e))}function Yd(i,t,e,n){return fn({},t==0?e:n,i)}function R0(i,t,e){return t==null?fo:[t,e]}var aS=R0;function lS(i,t,e){return t==null?fo:hc(t,e,Qd,!0)}function C0(i,t,e,n){return t==null?fo:fc(t,e,i.scales[n].log,!1)}var cS=C0;function P0(i,t,e,n){return t==null?fo:jd(t,e,i.scales[n].log,!1)}var hS=P0;function uS(i,t,e,n,s){let r=qn(bg(i),bg(t)),o=t-i,a=Pi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Xs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Wg(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=_n((e=+s)*Me))+"px"),[i,t,e]}function dS(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Fe(t[2]*Me,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Dn(i,t,e){let n={mode:be(i.mode,1)},s=n.mode;function r(y,M,P,I){let V=M.valToPct(y);return I+P*(M.dir==-1?1-V:V)}function o(y,M,P,I){let V=M.valToPct(y);return I+P*(M.dir==-1?V:1-V)}function a(y,M,P,I){return M.ori==0?r(y,M,P,I):o(y,M,P,I)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=yi(xv);if(i.id!=null&&(c.id=i.id),si(c,i.class),i.title){let y=yi(Sv,c);y.textContent=i.title}let h=Ci("canvas"),u=n.ctx=h.getContext("2d"),d=yi(Mv,c);wr("click",d,y=>{y.target===p&&(ze!=$r||$e!=Yr)&&Pn.click(n,y)},!0);let f=n.under=yi(wv,d);d.appendChild(h);let p=n.over=yi(Tv,d);i=po(i);let x=+be(i.pxAlign,1),m=zg(x);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let g=i.ms||.001,v=n.series=s==1?Gg(i.series||[],Dg,kg,!1):oS(i.series||[null],Og),A=n.axes=Gg(i.axes||[],Lg,Fg,!0),S=n.scales={},C=n.bands=i.bands||[];C.forEach(y=>{y.fill=ye(y.fill||null),y.dir=be(y.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:us,series:pe},T=(i.drawOrder||["axes","series"]).map(y=>_[y]);function k(y){let M=y.distr==3?P=>ms(P>0?P:y.clamp(n,P,y.min,y.max,y.key)):y.distr==4?P=>Fd(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let I=M(P),{_min:V,_max:J}=y,at=J-V;return(I-V)/at}}function F(y){let M=S[y];if(M==null){let P=(i.scales||Aa)[y]||Aa;if(P.from!=null){F(P.from);let I=fn({},S[P.from],P,{key:y});I.valToPct=k(I),S[y]=I}else{M=S[y]=fn({},y==E?_0:Yb,P),M.key=y;let I=M.time,V=M.range,J=Ws(V);if((y!=E||s==2&&!I)&&(J&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?_g:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?_g:{mode:1,hard:V[1],soft:V[1]}},J=!1),!J&&mc(V))){let at=V;V=(ft,vt,Dt)=>vt==null?fo:hc(vt,Dt,at)}M.range=ye(V||(I?aS:y==E?M.distr==3?cS:M.distr==4?hS:R0:M.distr==3?C0:M.distr==4?P0:lS)),M.auto=ye(J?!1:M.auto),M.clamp=ye(M.clamp||$b),M._min=M._max=null,M.valToPct=k(M)}}}F("x"),F("y"),s==1&&v.forEach(y=>{F(y.scale)}),A.forEach(y=>{F(y.scale)});for(let y in i.scales)F(y);let D=S[E],H=D.distr,W,L;D.ori==0?(si(c,vv),W=r,L=o):(si(c,bv),W=o,L=r);let X={};for(let y in S){let M=S[y];(M.min!=null||M.max!=null)&&(X[y]={min:M.min,max:M.max},M.min=M.max=null)}let Y=i.tzDate||(y=>new Date(_n(y/g))),G=i.fmtDate||nf,ct=g==1?vb(Y):Mb(Y),K=Cg(Y,Rg(g==1?xb:Sb,G)),Q=Ig(Y,Pg(Tb,G)),st=[],dt=n.legend=fn({},Rb,i.legend),ut=n.cursor=fn({},Nb,{drag:{y:s==2}},i.cursor),tt=dt.show,mt=ut.show,_t=dt.markers;dt.idxs=st,_t.width=ye(_t.width),_t.dash=ye(_t.dash),_t.stroke=ye(_t.stroke),_t.fill=ye(_t.fill);let At,St,Wt,ie=[],Vt=[],de,oe=!1,ee={};if(dt.live){let y=v[1]?v[1].values:null;oe=y!=null,de=oe?y(n,1,0):{_:0};for(let M in de)ee[M]=Jd}if(tt)if(At=Ci("table",Iv,c),Wt=Ci("tbody",null,At),dt.mount(n,At),oe){St=Ci("thead",null,At,Wt);let y=Ci("tr",null,St);Ci("th",null,y);for(var qe in de)Ci("th",rg,y).textContent=qe}else si(At,Dv),dt.live&&si(At,Lv);let Ue={show:!0},an={show:!1};function Pe(y,M){if(M==0&&(oe||!dt.live||s==2))return fo;let P=[],I=Ci("tr",Nv,Wt,Wt.childNodes[M]);si(I,y.class),y.show||si(I,Mr);let V=Ci("th",null,I);if(_t.show){let ft=yi(Fv,V);if(M>0){let vt=_t.width(n,M);vt&&(ft.style.border=vt+"px "+_t.dash(n,M)+" "+_t.stroke(n,M)),ft.style.background=_t.fill(n,M)}}let J=yi(rg,V);y.label instanceof HTMLElement?J.appendChild(y.label):J.textContent=y.label,M>0&&(_t.show||(J.style.color=y.width>0?_t.stroke(n,M):_t.fill(n,M)),xe("click",V,ft=>{if(ut._lock)return;Jt(ft);let vt=v.indexOf(y);if((ft.ctrlKey||ft.metaKey)!=dt.isolate){let Dt=v.some((Nt,Ut)=>Ut>0&&Ut!=vt&&Nt.show);v.forEach((Nt,Ut)=>{Ut>0&&Gi(Ut,Dt?Ut==vt?Ue:an:Ue,!0,dn.setSeries)})}else Gi(vt,{show:!y.show},!0,dn.setSeries)},!1),Kt&&xe(cg,V,ft=>{ut._lock||(Jt(ft),Gi(v.indexOf(y),Jr,!0,dn.setSeries))},!1));for(var at in de){let ft=Ci("td",Uv,I);ft.textContent="--",P.push(ft)}return[I,P]}let Mn=new Map;function xe(y,M,P,I=!0){let V=Mn.get(M)||{},J=ut.bind[y](n,M,P,I);J&&(wr(y,M,V[y]=J),Mn.set(M,V))}function mn(y,M,P){let I=Mn.get(M)||{};for(let V in I)(y==null||V==y)&&(Vd(V,M,I[V]),delete I[V]);y==null&&Mn.delete(M)}let Qe=0,ln=0,O=0,Ct=0,Yt=0,se=0,Mt=Yt,Le=se,Ht=O,qt=Ct,R=0,b=0,q=0,ht=0;n.bbox={};let ot=!1,yt=!1,xt=!1,et=!1,it=!1,pt=!1;function U(y,M,P){(P||y!=n.width||M!=n.height)&&rt(y,M),ae(!1),xt=!0,yt=!0,Fn()}function rt(y,M){n.width=Qe=O=y,n.height=ln=Ct=M,Yt=se=0,bt(),Gt();let P=n.bbox;R=P.left=br(Yt*Me,.5),b=P.top=br(se*Me,.5),q=P.width=br(O*Me,.5),ht=P.height=br(Ct*Me,.5)}let nt=3;function wt(){let y=!1,M=0;for(;!y;){M++;let P=Wr(M),I=Vi(M);y=M==nt||P&&I,y||(rt(n.width,n.height),yt=!0)}}function gt({width:y,height:M}){U(y,M)}n.setSize=gt;function bt(){let y=!1,M=!1,P=!1,I=!1;A.forEach((V,J)=>{if(V.show&&V._show){let{side:at,_size:ft}=V,vt=at%2,Dt=V.label!=null?V.labelSize:0,Nt=ft+Dt;Nt>0&&(vt?(O-=Nt,at==3?(Yt+=Nt,I=!0):P=!0):(Ct-=Nt,at==0?(se+=Nt,y=!0):M=!0))}}),zi[0]=y,zi[1]=P,zi[2]=M,zi[3]=I,O-=wi[1]+wi[3],Yt+=wi[3],Ct-=wi[2]+wi[0],se+=wi[0]}function Gt(){let y=Yt+O,M=se+Ct,P=Yt,I=se;function V(J,at){switch(J){case 1:return y+=at,y-at;case 2:return M+=at,M-at;case 3:return P-=at,P+at;case 0:return I-=at,I+at}}A.forEach((J,at)=>{if(J.show&&J._show){let ft=J.side;J._pos=V(ft,J._size),J.label!=null&&(J._lpos=V(ft,J.labelSize))}})}if(ut.dataIdx==null){let y=ut.hover,M=y.skip=new Set(y.skip??[]);M.add(void 0);let P=y.prox=ye(y.prox),I=y.bias??=0;ut.dataIdx=(V,J,at,ft)=>{if(J==0)return at;let vt=at,Dt=P(V,J,at,ft)??Ne,Nt=Dt>=0&&Dt<Ne,Ut=D.ori==0?O:Ct,ne=ut.left,Se=t[0],ve=t[J];if(M.has(ve[at])){vt=null;let me=null,Zt=null,Xt;if(I==0||I==-1)for(Xt=at;me==null&&Xt-- >0;)M.has(ve[Xt])||(me=Xt);if(I==0||I==1)for(Xt=at;Zt==null&&Xt++<ve.length;)M.has(ve[Xt])||(Zt=Xt);if(me!=null||Zt!=null)if(Nt){let Ve=me==null?-1/0:W(Se[me],D,Ut,0),nn=Zt==null?1/0:W(Se[Zt],D,Ut,0),An=ne-Ve,Ie=nn-ne;An<=Ie?An<=Dt&&(vt=me):Ie<=Dt&&(vt=Zt)}else vt=Zt==null?me:me==null?Zt:at-me<=Zt-at?me:Zt}else Nt&&xn(ne-W(Se[at],D,Ut,0))>Dt&&(vt=null);return vt}}let Jt=y=>{ut.event=y};ut.idxs=st,ut._lock=!1;let lt=ut.points;lt.show=ye(lt.show),lt.size=ye(lt.size),lt.stroke=ye(lt.stroke),lt.width=ye(lt.width),lt.fill=ye(lt.fill);let kt=n.focus=fn({},i.focus||{alpha:.3},ut.focus),Kt=kt.prox>=0,Rt=Kt&&lt.one,re=[],Be=[],zn=[];function na(y,M){let P=lt.show(n,M);if(P instanceof HTMLElement)return si(P,Pv),si(P,y.class),Zi(P,-10,-10,O,Ct),p.insertBefore(P,re[M]),P}function Hr(y,M){if(s==1||M>0){let P=s==1&&S[y.scale].time,I=y.value;y.value=P?wg(I)?Ig(Y,Pg(I,G)):I||Q:I||Wb,y.label=y.label||(P?Ub:Fb)}if(Rt||M>0){y.width=y.width==null?1:y.width,y.paths=y.paths||sS||Yv,y.fillTo=ye(y.fillTo||Zb),y.pxAlign=+be(y.pxAlign,x),y.pxRound=zg(y.pxAlign),y.stroke=ye(y.stroke||null),y.fill=ye(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=Xb(qn(1,y.width),1),I=y.points=fn({},{size:P,width:qn(1,P*.2),stroke:y.stroke,space:P*2,paths:rS,_stroke:null,_fill:null},y.points);I.show=ye(I.show),I.filter=ye(I.filter),I.fill=ye(I.fill),I.stroke=ye(I.stroke),I.paths=ye(I.paths),I.pxAlign=y.pxAlign}if(tt){let P=Pe(y,M);ie.splice(M,0,P[0]),Vt.splice(M,0,P[1]),dt.values.push(null)}if(mt){st.splice(M,0,null);let P=null;Rt?M==0&&(P=na(y,M)):M>0&&(P=na(y,M)),re.splice(M,0,P),Be.splice(M,0,0),zn.splice(M,0,0)}En("addSeries",M)}function od(y,M){M=M??v.length,y=s==1?Yd(y,M,Dg,kg):Yd(y,M,{},Og),v.splice(M,0,y),Hr(v[M],M)}n.addSeries=od;function El(y){if(v.splice(y,1),tt){dt.values.splice(y,1),Vt.splice(y,1);let M=ie.splice(y,1)[0];mn(null,M.firstChild),M.remove()}mt&&(st.splice(y,1),re.splice(y,1)[0].remove(),Be.splice(y,1),zn.splice(y,1)),En("delSeries",y)}n.delSeries=El;let zi=[!1,!1,!1,!1];function ls(y,M){if(y._show=y.show,y.show){let P=y.side%2,I=S[y.scale];I==null&&(y.scale=P?v[1].scale:E,I=S[y.scale]);let V=I.time;y.size=ye(y.size),y.space=ye(y.space),y.rotate=ye(y.rotate),Ws(y.incrs)&&y.incrs.forEach(at=>{!Xs.has(at)&&Xs.set(at,Qg(at))}),y.incrs=ye(y.incrs||(I.distr==2?gb:V?g==1?_b:bb:Sr)),y.splits=ye(y.splits||(V&&I.distr==1?ct:I.distr==3?Wd:I.distr==4?Bb:kb)),y.stroke=ye(y.stroke),y.grid.stroke=ye(y.grid.stroke),y.ticks.stroke=ye(y.ticks.stroke),y.border.stroke=ye(y.border.stroke);let J=y.values;y.values=Ws(J)&&!Ws(J[0])?ye(J):V?Ws(J)?Cg(Y,Rg(J,G)):wg(J)?wb(Y,J):J||K:J||Ob,y.filter=ye(y.filter||(I.distr>=3&&I.log==10?Vb:I.distr==3&&I.log==2?Gb:Kg)),y.font=Wg(y.font),y.labelFont=Wg(y.labelFont),y._size=y.size(n,null,M,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(zi[M]=!0,y._el=yi(Ev,d))}}function cs(y,M,P,I){let[V,J,at,ft]=P,vt=M%2,Dt=0;return vt==0&&(ft||J)&&(Dt=M==0&&!V||M==2&&!at?_n(Lg.size/3):0),vt==1&&(V||at)&&(Dt=M==1&&!J||M==3&&!ft?_n(Fg.size/2):0),Dt}let ia=n.padding=(i.padding||[cs,cs,cs,cs]).map(y=>ye(be(y,cs))),wi=n._padding=ia.map((y,M)=>y(n,M,zi,0)),tn,rn=null,on=null,Hi=s==1?v[0].idxs:null,ti=null,Ns=!1;function sa(y,M){if(t=y??[],n.data=n._data=t,s==2){tn=0;for(let P=1;P<v.length;P++)tn+=t[P][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ti=t[0],tn=ti.length;let P=t;if(H==2){P=t.slice();let I=P[0]=Array(tn);for(let V=0;V<tn;V++)I[V]=V}n._data=t=P}if(ae(!0),En("setData"),H==2&&(xt=!0),M!==!1){let P=D;P.auto(n,Ns)?ra():Os(E,P.min,P.max),et=et||ut.left>=0,pt=!0,Fn()}}n.setData=sa;function ra(){Ns=!0;let y,M;s==1&&(tn>0?(rn=Hi[0]=0,on=Hi[1]=tn-1,y=t[0][rn],M=t[0][on],H==2?(y=rn,M=on):y==M&&(H==3?[y,M]=fc(y,y,D.log,!1):H==4?[y,M]=jd(y,y,D.log,!1):D.time?M=y+_n(86400/g):[y,M]=hc(y,M,Qd,!0))):(rn=Hi[0]=y=null,on=Hi[1]=M=null)),Os(E,y,M)}let Vr,Fs,Gr,w,B,j,$,Z,Tt,Pt;function Et(y,M,P,I,V,J){y??=ag,P??=ef,I??="butt",V??=ag,J??="round",y!=Vr&&(u.strokeStyle=Vr=y),V!=Fs&&(u.fillStyle=Fs=V),M!=Gr&&(u.lineWidth=Gr=M),J!=B&&(u.lineJoin=B=J),I!=j&&(u.lineCap=j=I),P!=w&&u.setLineDash(w=P)}function It(y,M,P,I){M!=Fs&&(u.fillStyle=Fs=M),y!=$&&(u.font=$=y),P!=Z&&(u.textAlign=Z=P),I!=Tt&&(u.textBaseline=Tt=I)}function zt(y,M,P,I,V=0){if(I.length>0&&y.auto(n,Ns)&&(M==null||M.min==null)){let J=be(rn,0),at=be(on,I.length-1),ft=P.min==null?Vv(I,J,at,V,y.distr==3):[P.min,P.max];y.min=Ii(y.min,P.min=ft[0]),y.max=qn(y.max,P.max=ft[1])}}let jt={min:null,max:null};function fe(){for(let I in S){let V=S[I];X[I]==null&&(V.min==null||X[E]!=null&&V.auto(n,Ns))&&(X[I]=jt)}for(let I in S){let V=S[I];X[I]==null&&V.from!=null&&X[V.from]!=null&&(X[I]=jt)}X[E]!=null&&ae(!0);let y={};for(let I in X){let V=X[I];if(V!=null){let J=y[I]=po(S[I],Kv);if(V.min!=null)fn(J,V);else if(I!=E||s==2)if(tn==0&&J.from==null){let at=J.range(n,null,null,I);J.min=at[0],J.max=at[1]}else J.min=Ne,J.max=-Ne}}if(tn>0){v.forEach((I,V)=>{if(s==1){let J=I.scale,at=X[J];if(at==null)return;let ft=y[J];if(V==0){let vt=ft.range(n,ft.min,ft.max,J);ft.min=vt[0],ft.max=vt[1],rn=Pi(ft.min,t[0]),on=Pi(ft.max,t[0]),on-rn>1&&(t[0][rn]<ft.min&&rn++,t[0][on]>ft.max&&on--),I.min=ti[rn],I.max=ti[on]}else I.show&&I.auto&&zt(ft,at,I,t[V],I.sorted);I.idxs[0]=rn,I.idxs[1]=on}else if(V>0&&I.show&&I.auto){let[J,at]=I.facets,ft=J.scale,vt=at.scale,[Dt,Nt]=t[V],Ut=y[ft],ne=y[vt];Ut!=null&&zt(Ut,X[ft],J,Dt,J.sorted),ne!=null&&zt(ne,X[vt],at,Nt,at.sorted),I.min=at.min,I.max=at.max}});for(let I in y){let V=y[I],J=X[I];if(V.from==null&&(J==null||J.min==null)){let at=V.range(n,V.min==Ne?null:V.min,V.max==-Ne?null:V.max,I);V.min=at[0],V.max=at[1]}}}for(let I in y){let V=y[I];if(V.from!=null){let J=y[V.from];if(J.min==null)V.min=V.max=null;else{let at=V.range(n,J.min,J.max,I);V.min=at[0],V.max=at[1]}}}let M={},P=!1;for(let I in y){let V=y[I],J=S[I];if(J.min!=V.min||J.max!=V.max){J.min=V.min,J.max=V.max;let at=J.distr;J._min=at==3?ms(J.min):at==4?Fd(J.min,J.asinh):at==100?J.fwd(J.min):J.min,J._max=at==3?ms(J.max):at==4?Fd(J.max,J.asinh):at==100?J.fwd(J.max):J.max,M[I]=P=!0}}if(P){v.forEach((I,V)=>{s==2?V>0&&M.y&&(I._paths=null):M[I.scale]&&(I._paths=null)});for(let I in M)xt=!0,En("setScale",I);mt&&ut.left>=0&&(et=pt=!0)}for(let I in X)X[I]=null}function Bt(y){let M=Gd(rn-1,0,tn-1),P=Gd(on+1,0,tn-1);for(;y[M]==null&&M>0;)M--;for(;y[P]==null&&P<tn-1;)P++;return[M,P]}function pe(){if(tn>0){let y=v.some(M=>M._focus)&&Pt!=kt.alpha;y&&(u.globalAlpha=Pt=kt.alpha),v.forEach((M,P)=>{if(P>0&&M.show&&(Ze(P,!1),Ze(P,!0),M._paths==null)){let I=Pt;Pt!=M.alpha&&(u.globalAlpha=Pt=M.alpha);let V=s==2?[0,t[P][0].length-1]:Bt(t[P]);M._paths=M.paths(n,P,V[0],V[1]),Pt!=I&&(u.globalAlpha=Pt=I)}}),v.forEach((M,P)=>{if(P>0&&M.show){let I=Pt;Pt!=M.alpha&&(u.globalAlpha=Pt=M.alpha),M._paths!=null&&Ae(P,!1);{let V=M._paths!=null?M._paths.gaps:null,J=M.points.show(n,P,rn,on,V),at=M.points.filter(n,P,J,V);(J||at)&&(M.points._paths=M.points.paths(n,P,rn,on,at),Ae(P,!0))}Pt!=I&&(u.globalAlpha=Pt=I),En("drawSeries",P)}}),y&&(u.globalAlpha=Pt=1)}}function Ze(y,M){let P=M?v[y].points:v[y];P._stroke=P.stroke(n,y),P._fill=P.fill(n,y)}function Ae(y,M){let P=M?v[y].points:v[y],{stroke:I,fill:V,clip:J,flags:at,_stroke:ft=P._stroke,_fill:vt=P._fill,_width:Dt=P.width}=P._paths;Dt=Fe(Dt*Me,3);let Nt=null,Ut=Dt%2/2;M&&vt==null&&(vt=Dt>0?"#fff":ft);let ne=P.pxAlign==1&&Ut>0;if(ne&&u.translate(Ut,Ut),!M){let Se=R-Dt/2,ve=b-Dt/2,me=q+Dt,Zt=ht+Dt;Nt=new Path2D,Nt.rect(Se,ve,me,Zt)}M?Ft(ft,Dt,P.dash,P.cap,vt,I,V,at,J):Re(y,ft,Dt,P.dash,P.cap,vt,I,V,at,Nt,J),ne&&u.translate(-Ut,-Ut)}function Re(y,M,P,I,V,J,at,ft,vt,Dt,Nt){let Ut=!1;vt!=0&&C.forEach((ne,Se)=>{if(ne.series[0]==y){let ve=v[ne.series[1]],me=t[ne.series[1]],Zt=(ve._paths||Aa).band;Ws(Zt)&&(Zt=ne.dir==1?Zt[0]:Zt[1]);let Xt,Ve=null;ve.show&&Zt&&Wv(me,rn,on)?(Ve=ne.fill(n,Se)||J,Xt=ve._paths.clip):Zt=null,Ft(M,P,I,V,Ve,at,ft,vt,Dt,Nt,Xt,Zt),Ut=!0}}),Ut||Ft(M,P,I,V,J,at,ft,vt,Dt,Nt)}let gn=mo|qd;function Ft(y,M,P,I,V,J,at,ft,vt,Dt,Nt,Ut){Et(y,M,P,I,V),(vt||Dt||Ut)&&(u.save(),vt&&u.clip(vt),Dt&&u.clip(Dt)),Ut?(ft&gn)==gn?(u.clip(Ut),Nt&&u.clip(Nt),ge(V,at),cn(y,J,M)):ft&qd?(ge(V,at),u.clip(Ut),cn(y,J,M)):ft&mo&&(u.save(),u.clip(Ut),Nt&&u.clip(Nt),ge(V,at),u.restore(),cn(y,J,M)):(ge(V,at),cn(y,J,M)),(vt||Dt||Ut)&&u.restore()}function cn(y,M,P){P>0&&(M instanceof Map?M.forEach((I,V)=>{u.strokeStyle=Vr=V,u.stroke(I)}):M!=null&&y&&u.stroke(M))}function ge(y,M){M instanceof Map?M.forEach((P,I)=>{u.fillStyle=Fs=I,u.fill(P)}):M!=null&&y&&u.fill(M)}function hs(y,M,P,I){let V=A[y],J;if(I<=0)J=[0,0];else{let at=V._space=V.space(n,y,M,P,I),ft=V._incrs=V.incrs(n,y,M,P,I,at);J=uS(M,P,ft,I,at)}return V._found=J}function hn(y,M,P,I,V,J,at,ft,vt,Dt){let Nt=at%2/2;x==1&&u.translate(Nt,Nt),Et(ft,at,vt,Dt,ft),u.beginPath();let Ut,ne,Se,ve,me=V+(I==0||I==3?-J:J);P==0?(ne=V,ve=me):(Ut=V,Se=me);for(let Zt=0;Zt<y.length;Zt++)M[Zt]!=null&&(P==0?Ut=Se=y[Zt]:ne=ve=y[Zt],u.moveTo(Ut,ne),u.lineTo(Se,ve));u.stroke(),x==1&&u.translate(-Nt,-Nt)}function Wr(y){let M=!0;return A.forEach((P,I)=>{if(!P.show)return;let V=S[P.scale];if(V.min==null){P._show&&(M=!1,P._show=!1,ae(!1));return}else P._show||(M=!1,P._show=!0,ae(!1));let J=P.side,at=J%2,{min:ft,max:vt}=V,[Dt,Nt]=hs(I,ft,vt,at==0?O:Ct);if(Nt==0)return;let Ut=V.distr==2,ne=P._splits=P.splits(n,I,ft,vt,Dt,Nt,Ut),Se=V.distr==2?ne.map(Xt=>ti[Xt]):ne,ve=V.distr==2?ti[ne[1]]-ti[ne[0]]:Dt,me=P._values=P.values(n,P.filter(n,Se,I,Nt,ve),I,Nt,ve);P._rotate=J==2?P.rotate(n,me,I,Nt):0;let Zt=P._size;P._size=_i(P.size(n,me,I,y)),Zt!=null&&P._size!=Zt&&(M=!1)}),M}function Vi(y){let M=!0;return ia.forEach((P,I)=>{let V=P(n,I,zi,y);V!=wi[I]&&(M=!1),wi[I]=V}),M}function us(){for(let y=0;y<A.length;y++){let M=A[y];if(!M.show||!M._show)continue;let P=M.side,I=P%2,V,J,at=M.stroke(n,y),ft=P==0||P==3?-1:1,[vt,Dt]=M._found;if(M.label!=null){let Gn=M.labelGap*ft,ii=_n((M._lpos+Gn)*Me);It(M.labelFont[0],at,"center",P==2?"top":og),u.save(),I==1?(V=J=0,u.translate(ii,_n(b+ht/2)),u.rotate((P==3?-lc:lc)/2)):(V=_n(R+q/2),J=ii);let mr=Zg(M.label)?M.label(n,y,vt,Dt):M.label;u.fillText(mr,V,J),u.restore()}if(Dt==0)continue;let Nt=S[M.scale],Ut=I==0?q:ht,ne=I==0?R:b,Se=M._splits,ve=Nt.distr==2?Se.map(Gn=>ti[Gn]):Se,me=Nt.distr==2?ti[Se[1]]-ti[Se[0]]:vt,Zt=M.ticks,Xt=M.border,Ve=Zt.show?Zt.size:0,nn=_n(Ve*Me),An=_n((M.alignTo==2?M._size-Ve-M.gap:M.gap)*Me),Ie=M._rotate*-lc/180,sn=m(M._pos*Me),ei=(nn+An)*ft,Vn=sn+ei;J=I==0?Vn:0,V=I==1?Vn:0;let pi=M.font[0],Ti=M.align==1?lo:M.align==2?Ld:Ie>0?lo:Ie<0?Ld:I==0?"center":P==3?Ld:lo,Xi=Ie||I==1?"middle":P==2?"top":og;It(pi,at,Ti,Xi);let ni=M.font[1]*M.lineGap,mi=Se.map(Gn=>m(a(Gn,Nt,Ut,ne))),Ei=M._values;for(let Gn=0;Gn<Ei.length;Gn++){let ii=Ei[Gn];if(ii!=null){I==0?V=mi[Gn]:J=mi[Gn],ii=""+ii;let mr=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let Wn=0;Wn<mr.length;Wn++){let fm=mr[Wn];Ie?(u.save(),u.translate(V,J+Wn*ni),u.rotate(Ie),u.fillText(fm,0,0),u.restore()):u.fillText(fm,V,J+Wn*ni)}}}Zt.show&&hn(mi,Zt.filter(n,ve,y,Dt,me),I,P,sn,nn,Fe(Zt.width*Me,3),Zt.stroke(n,y),Zt.dash,Zt.cap);let qi=M.grid;qi.show&&hn(mi,qi.filter(n,ve,y,Dt,me),I,I==0?2:1,I==0?b:R,I==0?ht:q,Fe(qi.width*Me,3),qi.stroke(n,y),qi.dash,qi.cap),Xt.show&&hn([sn],[1],I==0?1:0,I==0?1:2,I==1?b:R,I==1?ht:q,Fe(Xt.width*Me,3),Xt.stroke(n,y),Xt.dash,Xt.cap)}En("drawAxes")}function ae(y){v.forEach((M,P)=>{P>0&&(M._paths=null,y&&(s==1?(M.min=null,M.max=null):M.facets.forEach(I=>{I.min=null,I.max=null})))})}let en=!1,Hn=!1,Ce=[];function un(){Hn=!1;for(let y=0;y<Ce.length;y++)En(...Ce[y]);Ce.length=0}function Fn(){en||(sb(Zp),en=!0)}function Al(y,M=!1){en=!0,Hn=M,y(n),Zp(),M&&Ce.length>0&&queueMicrotask(un)}n.batch=Al;function Zp(){if(ot&&(fe(),ot=!1),xt&&(wt(),xt=!1),yt){if(Ge(f,lo,Yt),Ge(f,"top",se),Ge(f,Ma,O),Ge(f,wa,Ct),Ge(p,lo,Yt),Ge(p,"top",se),Ge(p,Ma,O),Ge(p,wa,Ct),Ge(d,Ma,Qe),Ge(d,wa,ln),h.width=_n(Qe*Me),h.height=_n(ln*Me),A.forEach(({_el:y,_show:M,_size:P,_pos:I,side:V})=>{if(y!=null)if(M){let J=V===3||V===0?P:0,at=V%2==1;Ge(y,at?"left":"top",I-J),Ge(y,at?"width":"height",P),Ge(y,at?"top":"left",at?se:Yt),Ge(y,at?"height":"width",at?Ct:O),Hd(y,Mr)}else si(y,Mr)}),Vr=Fs=Gr=B=j=$=Z=Tt=w=null,Pt=1,la(!0),Yt!=Mt||se!=Le||O!=Ht||Ct!=qt){ae(!1);let y=O/Ht,M=Ct/qt;if(mt&&!et&&ut.left>=0){ut.left*=y,ut.top*=M,Xr&&Zi(Xr,_n(ut.left),0,O,Ct),qr&&Zi(qr,0,_n(ut.top),O,Ct);for(let P=0;P<re.length;P++){let I=re[P];I!=null&&(Be[P]*=y,zn[P]*=M,Zi(I,_i(Be[P]),_i(zn[P]),O,Ct))}}if(He.show&&!it&&He.left>=0&&He.width>0){He.left*=y,He.width*=y,He.top*=M,He.height*=M;for(let P in dd)Ge(Zr,P,He[P])}Mt=Yt,Le=se,Ht=O,qt=Ct}En("setSize"),yt=!1}Qe>0&&ln>0&&(u.clearRect(0,0,h.width,h.height),En("drawClear"),T.forEach(y=>y()),En("draw")),He.show&&it&&(Rl(He),it=!1),mt&&et&&(pr(null,!0,!1),et=!1),dt.show&&dt.live&&pt&&(hd(),pt=!1),l||(l=!0,n.status=1,En("ready")),Ns=!1,en=!1}n.redraw=(y,M)=>{xt=M||!1,y!==!1?Os(E,D.min,D.max):Fn()};function ad(y,M){let P=S[y];if(P.from==null){if(tn==0){let I=P.range(n,M.min,M.max,y);M.min=I[0],M.max=I[1]}if(M.min>M.max){let I=M.min;M.min=M.max,M.max=I}if(tn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;y==E&&P.distr==2&&tn>0&&(M.min=Pi(M.min,t[0]),M.max=Pi(M.max,t[0]),M.min==M.max&&M.max++),X[y]=M,ot=!0,Fn()}}n.setScale=ad;let ld,cd,Xr,qr,Jp,Kp,$r,Yr,jp,Qp,ze,$e,Us=!1,Pn=ut.drag,wn=Pn.x,Tn=Pn.y;mt&&(ut.x&&(ld=yi(Rv,p)),ut.y&&(cd=yi(Cv,p)),D.ori==0?(Xr=ld,qr=cd):(Xr=cd,qr=ld),ze=ut.left,$e=ut.top);let He=n.select=fn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Zr=He.show?yi(Av,He.over?p:f):null;function Rl(y,M){if(He.show){for(let P in y)He[P]=y[P],P in dd&&Ge(Zr,P,y[P]);M!==!1&&En("setSelect")}}n.setSelect=Rl;function gx(y){if(v[y].show)tt&&Hd(ie[y],Mr);else if(tt&&si(ie[y],Mr),mt){let P=Rt?re[0]:re[y];P!=null&&Zi(P,-10,-10,O,Ct)}}function Os(y,M,P){ad(y,{min:M,max:P})}function Gi(y,M,P,I){M.focus!=null&&bx(y),M.show!=null&&v.forEach((V,J)=>{J>0&&(y==J||y==null)&&(V.show=M.show,gx(J),s==2?(Os(V.facets[0].scale,null,null),Os(V.facets[1].scale,null,null)):Os(V.scale,null,null),Fn())}),P!==!1&&En("setSeries",y,M),I&&ca("setSeries",n,y,M)}n.setSeries=Gi;function yx(y,M){fn(C[y],M)}function _x(y,M){y.fill=ye(y.fill||null),y.dir=be(y.dir,-1),M=M??C.length,C.splice(M,0,y)}function xx(y){y==null?C.length=0:C.splice(y,1)}n.addBand=_x,n.setBand=yx,n.delBand=xx;function vx(y,M){v[y].alpha=M,mt&&re[y]!=null&&(re[y].style.opacity=M),tt&&ie[y]&&(ie[y].style.opacity=M)}let ds,ks,fr,Jr={focus:!0};function bx(y){if(y!=fr){let M=y==null,P=kt.alpha!=1;v.forEach((I,V)=>{if(s==1||V>0){let J=M||V==0||V==y;I._focus=M?null:J,P&&vx(V,J?1:kt.alpha)}}),fr=y,P&&Fn()}}tt&&Kt&&xe(hg,At,y=>{ut._lock||(Jt(y),fr!=null&&Gi(null,Jr,!0,dn.setSeries))});function Wi(y,M,P){let I=S[M];P&&(y=y/Me-(I.ori==1?se:Yt));let V=O;I.ori==1&&(V=Ct,y=V-y),I.dir==-1&&(y=V-y);let J=I._min,at=I._max,ft=y/V,vt=J+(at-J)*ft,Dt=I.distr;return Dt==3?uo(10,vt):Dt==4?qv(vt,I.asinh):Dt==100?I.bwd(vt):vt}function Sx(y,M){let P=Wi(y,E,M);return Pi(P,t[0],rn,on)}n.valToIdx=y=>Pi(y,t[0]),n.posToIdx=Sx,n.posToVal=Wi,n.valToPos=(y,M,P)=>S[M].ori==0?r(y,S[M],P?q:O,P?R:0):o(y,S[M],P?ht:Ct,P?b:0),n.setCursor=(y,M,P)=>{ze=y.left,$e=y.top,pr(null,M,P)};function tm(y,M){Ge(Zr,lo,He.left=y),Ge(Zr,Ma,He.width=M)}function em(y,M){Ge(Zr,"top",He.top=y),Ge(Zr,wa,He.height=M)}let oa=D.ori==0?tm:em,aa=D.ori==1?tm:em;function Mx(){if(tt&&dt.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&oe)continue;let M=dt.values[y],P=0;for(let I in M)Vt[y][P++].firstChild.nodeValue=M[I]}}function hd(y,M){if(y!=null&&(y.idxs?y.idxs.forEach((P,I)=>{st[I]=P}):Jv(y.idx)||st.fill(y.idx),dt.idx=st[0]),tt&&dt.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!oe)&&wx(P,st[P]);Mx()}pt=!1,M!==!1&&En("setLegend")}n.setLegend=hd;function wx(y,M){let P=v[y],I=y==0&&H==2?ti:t[y],V;oe?V=P.values(n,y,M)??ee:(V=P.value(n,M==null?null:I[M],y,M),V=V==null?ee:{_:V}),dt.values[y]=V}function pr(y,M,P){jp=ze,Qp=$e,[ze,$e]=ut.move(n,ze,$e),ut.left=ze,ut.top=$e,mt&&(Xr&&Zi(Xr,_n(ze),0,O,Ct),qr&&Zi(qr,0,_n($e),O,Ct));let I,V=rn>on;ds=Ne,ks=null;let J=D.ori==0?O:Ct,at=D.ori==1?O:Ct;if(ze<0||tn==0||V){I=ut.idx=null;for(let ft=0;ft<v.length;ft++){let vt=re[ft];vt!=null&&Zi(vt,-10,-10,O,Ct)}Kt&&Gi(null,Jr,!0,y==null&&dn.setSeries),dt.live&&(st.fill(I),pt=!0)}else{let ft,vt,Dt;s==1&&(ft=D.ori==0?ze:$e,vt=Wi(ft,E),I=ut.idx=Pi(vt,t[0],rn,on),Dt=W(t[0][I],D,J,0));let Nt=-10,Ut=-10,ne=0,Se=0,ve=!0,me="",Zt="";for(let Xt=s==2?1:0;Xt<v.length;Xt++){let Ve=v[Xt],nn=st[Xt],An=nn==null?null:s==1?t[Xt][nn]:t[Xt][1][nn],Ie=ut.dataIdx(n,Xt,I,vt),sn=Ie==null?null:s==1?t[Xt][Ie]:t[Xt][1][Ie];if(pt=pt||sn!=An||Ie!=nn,st[Xt]=Ie,Xt>0&&Ve.show){let ei=Ie==null?-10:Ie==I?Dt:W(s==1?t[0][Ie]:t[Xt][0][Ie],D,J,0),Vn=sn==null?-10:L(sn,s==1?S[Ve.scale]:S[Ve.facets[1].scale],at,0);if(Kt&&sn!=null){let pi=D.ori==1?ze:$e,Ti=xn(kt.dist(n,Xt,Ie,Vn,pi));if(Ti<ds){let Xi=kt.bias;if(Xi!=0){let ni=Wi(pi,Ve.scale),mi=sn>=0?1:-1,Ei=ni>=0?1:-1;Ei==mi&&(Ei==1?Xi==1?sn>=ni:sn<=ni:Xi==1?sn<=ni:sn>=ni)&&(ds=Ti,ks=Xt)}else ds=Ti,ks=Xt}}if(pt||Rt){let pi,Ti;D.ori==0?(pi=ei,Ti=Vn):(pi=Vn,Ti=ei);let Xi,ni,mi,Ei,qi,Gn,ii=!0,mr=lt.bbox;if(mr!=null){ii=!1;let Wn=mr(n,Xt);mi=Wn.left,Ei=Wn.top,Xi=Wn.width,ni=Wn.height}else mi=pi,Ei=Ti,Xi=ni=lt.size(n,Xt);if(Gn=lt.fill(n,Xt),qi=lt.stroke(n,Xt),Rt)Xt==ks&&ds<=kt.prox&&(Nt=mi,Ut=Ei,ne=Xi,Se=ni,ve=ii,me=Gn,Zt=qi);else{let Wn=re[Xt];Wn!=null&&(Be[Xt]=mi,zn[Xt]=Ei,yg(Wn,Xi,ni,ii),mg(Wn,Gn,qi),Zi(Wn,_i(mi),_i(Ei),O,Ct))}}}}if(Rt){let Xt=kt.prox,Ve=fr==null?ds<=Xt:ds>Xt||ks!=fr;if(pt||Ve){let nn=re[0];nn!=null&&(Be[0]=Nt,zn[0]=Ut,yg(nn,ne,Se,ve),mg(nn,me,Zt),Zi(nn,_i(Nt),_i(Ut),O,Ct))}}}if(He.show&&Us)if(y!=null){let[ft,vt]=dn.scales,[Dt,Nt]=dn.match,[Ut,ne]=y.cursor.sync.scales,Se=y.cursor.drag;if(wn=Se._x,Tn=Se._y,wn||Tn){let{left:ve,top:me,width:Zt,height:Xt}=y.select,Ve=y.scales[Ut].ori,nn=y.posToVal,An,Ie,sn,ei,Vn,pi=ft!=null&&Dt(ft,Ut),Ti=vt!=null&&Nt(vt,ne);pi&&wn?(Ve==0?(An=ve,Ie=Zt):(An=me,Ie=Xt),sn=S[ft],ei=W(nn(An,Ut),sn,J,0),Vn=W(nn(An+Ie,Ut),sn,J,0),oa(Ii(ei,Vn),xn(Vn-ei))):oa(0,J),Ti&&Tn?(Ve==1?(An=ve,Ie=Zt):(An=me,Ie=Xt),sn=S[vt],ei=L(nn(An,ne),sn,at,0),Vn=L(nn(An+Ie,ne),sn,at,0),aa(Ii(ei,Vn),xn(Vn-ei))):aa(0,at)}else fd()}else{let ft=xn(jp-Jp),vt=xn(Qp-Kp);if(D.ori==1){let ne=ft;ft=vt,vt=ne}wn=Pn.x&&ft>=Pn.dist,Tn=Pn.y&&vt>=Pn.dist;let Dt=Pn.uni;Dt!=null?wn&&Tn&&(wn=ft>=Dt,Tn=vt>=Dt,!wn&&!Tn&&(vt>ft?Tn=!0:wn=!0)):Pn.x&&Pn.y&&(wn||Tn)&&(wn=Tn=!0);let Nt,Ut;wn&&(D.ori==0?(Nt=$r,Ut=ze):(Nt=Yr,Ut=$e),oa(Ii(Nt,Ut),xn(Ut-Nt)),Tn||aa(0,at)),Tn&&(D.ori==1?(Nt=$r,Ut=ze):(Nt=Yr,Ut=$e),aa(Ii(Nt,Ut),xn(Ut-Nt)),wn||oa(0,J)),!wn&&!Tn&&(oa(0,0),aa(0,0))}if(Pn._x=wn,Pn._y=Tn,y==null){if(P){if(dm!=null){let[ft,vt]=dn.scales;dn.values[0]=ft!=null?Wi(D.ori==0?ze:$e,ft):null,dn.values[1]=vt!=null?Wi(D.ori==1?ze:$e,vt):null}ca(Dd,n,ze,$e,O,Ct,I)}if(Kt){let ft=P&&dn.setSeries,vt=kt.prox;fr==null?ds<=vt&&Gi(ks,Jr,!0,ft):ds>vt?Gi(null,Jr,!0,ft):ks!=fr&&Gi(ks,Jr,!0,ft)}}pt&&(dt.idx=I,hd()),M!==!1&&En("setCursor")}let Bs=null;Object.defineProperty(n,"rect",{get(){return Bs==null&&la(!1),Bs}});function la(y=!1){y?Bs=null:(Bs=p.getBoundingClientRect(),En("syncRect",Bs))}function nm(y,M,P,I,V,J,at){ut._lock||Us&&y!=null&&y.movementX==0&&y.movementY==0||(ud(y,M,P,I,V,J,at,!1,y!=null),y!=null?pr(null,!0,!0):pr(M,!0,!1))}function ud(y,M,P,I,V,J,at,ft,vt){if(Bs==null&&la(!1),Jt(y),y!=null)P=y.clientX-Bs.left,I=y.clientY-Bs.top;else{if(P<0||I<0){ze=-10,$e=-10;return}let[Dt,Nt]=dn.scales,Ut=M.cursor.sync,[ne,Se]=Ut.values,[ve,me]=Ut.scales,[Zt,Xt]=dn.match,Ve=M.axes[0].side%2==1,nn=D.ori==0?O:Ct,An=D.ori==1?O:Ct,Ie=Ve?J:V,sn=Ve?V:J,ei=Ve?I:P,Vn=Ve?P:I;if(ve!=null?P=Zt(Dt,ve)?a(ne,S[Dt],nn,0):-10:P=nn*(ei/Ie),me!=null?I=Xt(Nt,me)?a(Se,S[Nt],An,0):-10:I=An*(Vn/sn),D.ori==1){let pi=P;P=I,I=pi}}vt&&(M==null||M.cursor.event.type==Dd)&&((P<=1||P>=O-1)&&(P=br(P,O)),(I<=1||I>=Ct-1)&&(I=br(I,Ct))),ft?(Jp=P,Kp=I,[$r,Yr]=ut.move(n,P,I)):(ze=P,$e=I)}let dd={width:0,height:0,left:0,top:0};function fd(){Rl(dd,!1)}let im,sm,rm,om;function am(y,M,P,I,V,J,at){Us=!0,wn=Tn=Pn._x=Pn._y=!1,ud(y,M,P,I,V,J,at,!0,!1),y!=null&&(xe(Nd,Bd,lm,!1),ca(lg,n,$r,Yr,O,Ct,null));let{left:ft,top:vt,width:Dt,height:Nt}=He;im=ft,sm=vt,rm=Dt,om=Nt}function lm(y,M,P,I,V,J,at){Us=Pn._x=Pn._y=!1,ud(y,M,P,I,V,J,at,!1,!0);let{left:ft,top:vt,width:Dt,height:Nt}=He,Ut=Dt>0||Nt>0,ne=im!=ft||sm!=vt||rm!=Dt||om!=Nt;if(Ut&&ne&&Rl(He),Pn.setScale&&Ut&&ne){let Se=ft,ve=Dt,me=vt,Zt=Nt;if(D.ori==1&&(Se=vt,ve=Nt,me=ft,Zt=Dt),wn&&Os(E,Wi(Se,E),Wi(Se+ve,E)),Tn)for(let Xt in S){let Ve=S[Xt];Xt!=E&&Ve.from==null&&Ve.min!=Ne&&Os(Xt,Wi(me+Zt,Xt),Wi(me,Xt))}fd()}else ut.lock&&(ut._lock=!ut._lock,pr(M,!0,y!=null));y!=null&&(mn(Nd,Bd),ca(Nd,n,ze,$e,O,Ct,null))}function Tx(y,M,P,I,V,J,at){if(ut._lock)return;Jt(y);let ft=Us;if(Us){let vt=!0,Dt=!0,Nt=10,Ut,ne;D.ori==0?(Ut=wn,ne=Tn):(Ut=Tn,ne=wn),Ut&&ne&&(vt=ze<=Nt||ze>=O-Nt,Dt=$e<=Nt||$e>=Ct-Nt),Ut&&vt&&(ze=ze<$r?0:O),ne&&Dt&&($e=$e<Yr?0:Ct),pr(null,!0,!0),Us=!1}ze=-10,$e=-10,st.fill(null),pr(null,!0,!0),ft&&(Us=ft)}function cm(y,M,P,I,V,J,at){ut._lock||(Jt(y),ra(),fd(),y!=null&&ca(ug,n,ze,$e,O,Ct,null))}function hm(){A.forEach(dS),U(n.width,n.height,!0)}wr(cc,ho,hm);let Kr={};Kr.mousedown=am,Kr.mousemove=nm,Kr.mouseup=lm,Kr.dblclick=cm,Kr.setSeries=(y,M,P,I)=>{let V=dn.match[2];P=V(n,M,P),P!=-1&&Gi(P,I,!0,!1)},mt&&(xe(lg,p,am),xe(Dd,p,nm),xe(cg,p,y=>{Jt(y),la(!1)}),xe(hg,p,Tx),xe(ug,p,cm),$d.add(n),n.syncRect=la);let Cl=n.hooks=i.hooks||{};function En(y,M,P){Hn?Ce.push([y,M,P]):y in Cl&&Cl[y].forEach(I=>{I.call(null,n,M,P)})}(i.plugins||[]).forEach(y=>{for(let M in y.hooks)Cl[M]=(Cl[M]||[]).concat(y.hooks[M])});let um=(y,M,P)=>P,dn=fn({key:null,setSeries:!1,filters:{pub:Sg,sub:Sg},scales:[E,v[1]?v[1].scale:null],match:[Mg,Mg,um],values:[null,null]},ut.sync);dn.match.length==2&&dn.match.push(um),ut.sync=dn;let dm=dn.key,pd=x0(dm);function ca(y,M,P,I,V,J,at){dn.filters.pub(y,M,P,I,V,J,at)&&pd.pub(y,M,P,I,V,J,at)}pd.sub(n);function Ex(y,M,P,I,V,J,at){dn.filters.sub(y,M,P,I,V,J,at)&&Kr[y](null,M,P,I,V,J,at)}n.pub=Ex;function Ax(){pd.unsub(n),$d.delete(n),Mn.clear(),Vd(cc,ho,hm),c.remove(),At?.remove(),En("destroy")}n.destroy=Ax;function md(){En("init",i,t),sa(t||i.data,!1),X[E]?ad(E,X[E]):ra(),it=He.show&&(He.width>0||He.height>0),et=pt=!0,U(i.width,i.height)}return v.forEach(Hr),A.forEach(ls),e?e instanceof HTMLElement?(e.appendChild(c),md()):e(n,md):md(),n}Dn.assign=fn;Dn.fmtNum=tf;Dn.rangeNum=hc;Dn.rangeLog=fc;Dn.rangeAsinh=jd;Dn.orient=Er;Dn.pxRatio=Me;Dn.join=ib;Dn.fmtDate=nf,Dn.tzDate=pb;Dn.sync=x0;{Dn.addGap=Jb,Dn.clipGaps=gc;let i=Dn.paths={points:T0};i.linear=A0,i.stepped=Qb,i.bars=tS,i.spline=nS}var hf="http://www.w3.org/2000/svg",vc=class{root=N("ul",{class:"legend"});#t=[];list(t){this.#t=t.map(({unlisted:s,says:r})=>s||!r?null:N("span",{class:"legend-value"}));let e=s=>{let r=this.#t[t.indexOf(s)];return N("li",{},fS(s),s.label,...r?[" ",r]:[])},n=t.filter(({unlisted:s})=>!s);this.root.replaceChildren(...n.filter(({alpha:s})=>!s).map(e),...n.filter(({alpha:s})=>s).map(e))}write(t){this.#t.forEach((e,n)=>e&&le(e,t[n]??""))}};function fS({token:i,dash:t,width:e,alpha:n,marker:s}){let r=document.createElementNS(hf,"svg");for(let[l,c]of Object.entries({width:"22",height:"10",viewBox:"0 0 22 10","aria-hidden":"true"}))r.setAttribute(l,c);let o=document.createElementNS(hf,"line"),a={x1:"0",x2:"22",y1:"5",y2:"5","stroke-width":`${e??1.6}`,"stroke-dasharray":(t??[]).join(" "),opacity:`${n??1}`};for(let[l,c]of Object.entries(a))o.setAttribute(l,c);return o.style.stroke=`var(--${i})`,r.append(o),s&&r.append(pS(s,i)),r}function pS(i,t){let e=document.createElementNS(hf,"path"),n={disc:"M7.5 5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z",square:"M8 2h6v6h-6z",diamond:"M11 1l4 4l-4 4l-4 -4z",triangle:"M11 1l4 7h-8z"};return e.setAttribute("d",n[i]),e.style.fill=`var(--${t})`,e}function I0(i,t,e,n){let{ctx:s}=i,r=devicePixelRatio,o=i.data[0],a=i.bbox.width/Math.max(1,o.length),l=Math.min(3.2*r,Math.max(1.2*r,a*.32));s.save(),s.fillStyle=t.dash?n:e,s.strokeStyle=e,s.globalAlpha=t.alpha??1,s.lineWidth=r,s.beginPath();for(let c=0;c<t.values.length;c++){let h=t.values[c];h>0&&mS(s,t.marker,i.valToPos(o[c],"x",!0),i.valToPos(h,"y",!0),l)}s.fill(),s.stroke(),s.restore()}function mS(i,t,e,n,s){if(t==="disc")i.moveTo(e+s,n),i.arc(e,n,s,0,2*Math.PI);else if(t==="square")i.rect(e-s,n-s,2*s,2*s);else{let r=1.3*s;i.moveTo(e,n-r),i.lineTo(e+r,t==="diamond"?n:n+r),i.lineTo(t==="diamond"?e:e-r,n+r),t==="diamond"&&i.lineTo(e-r,n),i.closePath()}}function L0(i,t,e){let{bbox:n,scales:s}=i,[r,o]=[s.x.min,s.x.max],a=n.width/(o-r),l=yS(i),c=new Path2D,[h,u,d,f]=[NaN,NaN,NaN,NaN],[p,x]=[-1/0,1/0],m=!1;for(let g of gS(t,e,(o-r)/(n.width/(1.5*devicePixelRatio)))){let v=n.left+(t[g]-r)*a,A=l(e[g]);if(!Number.isFinite(A)){m&&c.lineTo(d,f),m=!1;continue}if(!m)c.moveTo(v,A),[h,u,p,x,m]=[v,A,-1/0,1/0,!0];else{let S=(A-u)/(v-h);(S<p||S>x)&&(c.lineTo(d,f),[h,u,p,x]=[d,f,-1/0,1/0]),p=Math.max(p,(A-.3-u)/(v-h)),x=Math.min(x,(A+.3-u)/(v-h))}[d,f]=[v,A]}return m&&c.lineTo(d,f),{stroke:c,flags:1}}function gS(i,t,e){let n=i.length-1,s=(i[n]-i[0])/n<e/3,r=[];for(let o=0;o<=n;){let a=i[o]+e,[l,c]=[o,o],h=o++;for(;s&&o<=n&&i[o]<a;o++)t[o]<t[l]&&(l=o),t[o]>t[c]&&(c=o);l===c?r.push(h):r.push(Math.min(l,c),Math.max(l,c))}return r}function yS(i){let{bbox:t,scales:e}=i,{min:n,max:s,distr:r}=e.y,o=t.top+t.height;if(r===3){let l=t.height/Math.log10(s/n);return c=>o-Math.log10(c/n)*l}let a=t.height/(s-n);return l=>o-(l-n)*a}function D0(i,t){let e=new Path2D,[n,s]=[i[0],t[0]],[r,o,a]=[0,0,0];e.moveTo(n,s);for(let l=1;l<i.length;l++){let[c,h]=[i[l]-n,t[l]-s],u=Math.hypot(c,h);if(a===0){u>2*.3&&([r,o,a]=[c/u,h/u,u]);continue}let d=c*r+h*o;if(Math.abs(c*o-h*r)<.3&&d>a-.3){a=Math.max(a,d);continue}[n,s,a]=[i[l-1],t[l-1],0],e.lineTo(n,s),l--}return e.lineTo(i[i.length-1],t[t.length-1]),e}function N0(i,t){let e=n=>{let{left:s,width:r}=i.getBoundingClientRect();t(Math.min(Math.max(n.clientX-s,0),r))};i.addEventListener("pointerdown",n=>{n.button===0&&(i.setPointerCapture(n.pointerId),e(n))}),i.addEventListener("pointermove",n=>{i.hasPointerCapture(n.pointerId)&&e(n)})}function ys(i,t=.07){let[e,n]=[1/0,-1/0];for(let r of i)for(let o=0;o<r.length;o++){let a=r[o];a<e&&a>-1/0&&(e=a),a>n&&a<1/0&&(n=a)}if(e>n)return[-1,1];let s=t*(n-e)||Math.abs(n)*.5||1;return[e-s,n+s]}function F0(i){let[t,e]=[1/0,0];for(let s of i)for(let r of s)r>0&&r<t&&(t=r),r>e&&r<1/0&&(e=r);if(e===0)return[.1,10];let n=Math.max(1.6,Math.sqrt(10*t/e));return[t/n,e*n]}var _S=10;function U0(i,t){let[e,n]=[Math.floor(Math.log10(i)),Math.ceil(Math.log10(t))],s=n-e>_S?[1]:[1,2,3,4,5,6,7,8,9],r=[];for(let o=e;o<=n;o++)for(let a of s){let l=+`${a}e${o}`;l>=i&&l<=t&&r.push(l)}return r}var O0=new Float64Array(0),k0='11px system-ui, -apple-system, "Segoe UI", sans-serif',xS=120,vS=[1,2,5,10,20,50,100,200,500,1e3],qs={dash:[4,3],width:1,alpha:.65},Ji=class{legend=new vc;host;#t;#e=N("div",{class:"time-cursor",hidden:!0});#n=N("div",{class:"dot",hidden:!0});#i;#s=null;#a=O0;#o=[];#r="";#l={x:[0,1],y:[0,1]};#c=null;#h=null;#u=!1;#d=0;constructor(t,e){this.host=t,this.#t=e,e.dot&&(this.#n.style.background=`var(--${e.dot})`),t.style.minHeight=`${e.height}px`,this.#i=new ResizeObserver(()=>{let n=Math.floor(t.clientWidth);this.#s&&n>0&&n!==this.#s.width&&this.#s.setSize({width:n,height:e.height})}),this.#i.observe(t)}draw(t,e,n){this.#a=t,this.#o=e,this.#l=n;let s=[t,...e.map(a=>a.time?O0:a.values)],r=JSON.stringify(e.map(({values:a,time:l,...c})=>c));(!this.#s||r!==this.#r)&&(this.#r=r,this.#s=this.#y(s));let o=this.#s;o.batch(()=>{o.setData(s,!1),o.setScale("x",{min:n.x[0],max:n.x[1]}),o.setScale("y",{min:n.y[0],max:n.y[1]})}),this.#m()}cursor(t){if(this.#c=t,!this.#s)return;let e=t===null||t<this.#l.x[0]||t>this.#l.x[1];this.#e.hidden=e,!e&&(this.#e.style.transform=`translateX(${this.#s.valToPos(t,"x")}px)`,this.#u||(this.#d||=window.setTimeout(()=>this.#m(),xS)))}point(t){this.#h=t,this.#n.hidden=!t,t&&this.#s&&(this.#n.style.transform=`translate(${this.#s.valToPos(t[0],"x")}px, ${this.#s.valToPos(t[1],"y")}px)`)}repaint(){this.#s?.redraw(!1,!1)}destroy(){this.#i.disconnect(),clearTimeout(this.#d),this.#s?.destroy()}#m(){clearTimeout(this.#d),this.#d=0,this.#s&&!this.#u&&this.#f(this.#c)}#f(t){let e=({says:n,time:s,values:r})=>t===null||!n?"":n(r[_a(s??this.#a,t)]??NaN);this.legend.write(this.#o.map(e))}#y(t){this.#s?.destroy(),this.legend.list(this.#o);let{look:e,height:n,whole:s,seek:r}=this.#t,o={stroke:()=>e.colour("line"),width:1},a={stroke:()=>e.colour("faint"),font:k0,labelFont:k0,grid:o,ticks:{...o,size:4},gap:4},l=new Dn({width:Math.max(80,Math.floor(this.host.clientWidth)),height:n,padding:[8,10,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:6},bind:{dblclick:()=>null}},scales:{x:{time:!1,auto:!1,min:this.#l.x[0],max:this.#l.x[1]},y:{auto:!1,distr:this.#t.log?3:1,min:this.#l.y[0],max:this.#l.y[1]}},axes:[{...a,label:this.#t.xTitle,labelSize:16,size:26,values:(c,h)=>Id(h,this.#l.xFactor??1),...s?{incrs:vS}:{}},{...a,size:52,space:28,...this.#t.log?{splits:(c,h,u,d)=>U0(u,d),filter:(c,h)=>h,grid:{...o,filter:(c,h)=>ng(h)}}:{},values:(c,h)=>this.#t.log?sg(h):Id(h,this.#l.factor??1)}],series:[{},...this.#o.map(c=>this.#_(c))],hooks:{drawClear:[c=>this.#t.under?.(c)],draw:[c=>this.#x(c)],setCursor:[c=>this.#p(c)]}},t,this.host);return l.over.append(this.#e,this.#n),r&&N0(l.over,c=>r(l.posToVal(c,"x"))),l}#_(t){return{stroke:()=>this.#t.look.colour(t.token),width:t.width??1.4,dash:t.dash??[],alpha:t.alpha??1,paths:(e,n)=>{let{time:s,values:r}=this.#o[n-1];return L0(e,s??this.#a,r)},points:{show:!1}}}#x(t){for(let e of this.#o)e.marker&&I0(t,e,this.#t.look.colour(e.token),this.#t.look.colour("card"));this.#t.over?.(t),this.cursor(this.#c),this.point(this.#h)}#p(t){let{idx:e,left:n=-1,top:s=-1}=t.cursor,r=e!=null;!r&&!this.#u||(this.#u=r,this.#t.hover?.(r?[t.posToVal(n,"x"),t.posToVal(s,"y")]:null),r?this.#f(this.#a[e]??null):this.#m())}};function Ki(i){return i.span==="trial"?i.trial:null}function $s(i){return i.span==="trial"?i.time:i.trial*i.run.picture.duration+i.time}function Ar(i){let{duration:t,trials:e}=i.run.picture;return i.span==="trial"?t:t*Math.max(1,e,i.pinned?.run.picture.trials??0)}function Ca(i,t){return i.run.ports.findIndex(({name:e,motion_unit:n})=>e===t.name&&n===t.motion_unit)}function xo(i,t,e){let{pinned:n}=i;if(!n||!n.run.hasSignal(t))return null;let s=e?Ca(n,e):0,r=Ki(i);return s<0||r!==null&&r>=n.run.picture.trials?null:n.run.curve(t,s,r)}var B0=new Map;function bS(i,t){let e=B0.get(t);if(e)return e;let n=document.createElement("canvas");n.width=n.height=8;let s=n.getContext("2d");if(!s)return t;s.strokeStyle=t,s.beginPath();for(let o of[-8,0,8])s.moveTo(o,8),s.lineTo(o+8,0);s.stroke();let r=i.createPattern(n,"repeat");return r?(B0.set(t,r),r):t}function uf(i,t,e,n){let{ctx:s,bbox:r}=i,o=n>0?r.top:r.top+r.height,a=h=>Math.min(Math.max(h,r.top),r.top+r.height),{time:l,values:c}=e;s.save(),s.beginPath(),s.moveTo(i.valToPos(l[0],"x",!0),o);for(let h=0;h<c.length;h++)(h===0||h===c.length-1||c[h]!==c[h-1]||c[h]!==c[h+1])&&s.lineTo(i.valToPos(l[h],"x",!0),a(i.valToPos(c[h],"y",!0)));s.lineTo(i.valToPos(l[l.length-1],"x",!0),o),s.closePath(),s.fillStyle=t.colour("constraint"),s.globalAlpha=.1,s.fill(),s.fillStyle=bS(s,t.colour("constraint")),s.globalAlpha=.35,s.fill(),s.restore()}function z0(i,t,e,n){let{ctx:s,bbox:r}=i;s.save(),s.strokeStyle=t.colour("faint"),s.globalAlpha=.6,s.lineWidth=devicePixelRatio,s.beginPath();for(let o=1;o<e;o++){let a=Math.round(i.valToPos(o*n,"x",!0));s.moveTo(a,r.top+r.height),s.lineTo(a,r.top+r.height-6*devicePixelRatio)}s.stroke(),s.restore()}var SS=0,ji=class{root;body=N("div",{class:"card-body"});#t=N("span",{});#e=N("span",{class:"card-unit"});#n=N("p",{class:"card-caption"});constructor(...t){let e=`card-${++SS}`,n=N("h3",{id:e},this.#t," ",this.#e);this.root=N("article",{class:"card","aria-labelledby":e},n,this.#n,...t,this.body)}title(t,e){le(this.#t,t),le(this.#e,e)}caption(t){le(this.#n,t)}};var Ys=class{card;#t;#e=zs();#n=0;#i=1;constructor(t,e,...n){this.#t=new Ji(this.#e,{look:t.look,height:e,xTitle:"time t [s]",seek:t.seek,under:s=>{this.under(s),z0(s,t.look,this.#n,this.#i)}}),this.card=new ji(this.#t.legend.root),this.card.body.append(this.#e,...n)}draw(t){let{time:e,lines:n,measure:s,y:r,heading:o,caption:a}=this.course(t);this.#n=Ki(t)===null?t.run.picture.trials:0,this.#i=t.run.picture.duration;let l=r??ys(n.map(({values:c})=>c));this.#t.draw(e,n,{x:[0,Ar(t)],y:l,factor:s.factor}),this.card.title(...o),this.card.caption(a),$i(this.#e,`${o[0]} against time. ${a}`)}cursor(t){this.#t.cursor($s(t))}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}under(t){}},vo=i=>i===null?"in all trials":`in trial ${i}`;var bc=class extends Ys{#t;constructor(t,e){super(t,170),this.#t=e}course(t){let{run:e}=t,n=e.ports[this.#t],{token:s}=Yi(e.ports,this.#t),r=Ki(t),o=e.curve("delivered",this.#t,r),a=e.curve("command",this.#t,r),l=xo(t,"delivered",n),c=e.largest("delivered",this.#t,r),h=e.largest("command",this.#t,r),u=new Je(Math.max(c,h)||1,n.effort_unit),d=p=>u.text(p),f=[];return l&&f.push({label:`${t.pinned.label}, delivered`,token:s,...l,...qs,says:d}),f.push({label:"command",token:"faint",values:a.values,dash:[5,3],width:1,says:d}),f.push({label:"delivered",token:s,values:o.values,says:d}),{time:o.time,lines:f,measure:u,heading:[ps(vr(n)),`[${u.unit}]`],caption:`Largest ${u.text(h)} commanded, ${u.text(c)} delivered ${vo(r)}.`}}};var H0=[["initial","at the start"],["law","by the control law"],["actuator","by the actuators' error"],["disturbance","by disturbances"],["load","by the distributed load"],["dissipated","damped away"],["resets","by the resets between trials"],["final","at the end"]],V0=new Set(["initial","law","final"]),MS=new Set(["dissipated"]),Sc=class{root=N("details",{class:"account",open:!0},N("summary",{},"Account of the whole run"));#t=N("tbody",{});#e=N("p",{class:"account-closing"});constructor(){this.root.append(N("table",{},N("caption",{class:"unseen"},"Energy account"),this.#t),this.#e)}fill(t,e){let n=Math.max(...H0.map(([c])=>Math.abs(t[c]??0))),s=new Je(n,"J"),r=(c,h)=>{if(c[h]===null)return"–";let u=(MS.has(h)?-1:1)*(c[h]??0);return V0.has(h)&&(h==="initial"||h==="final")?s.text(u):`${u>0?"+":""}${s.text(u)}`},o=(c,h)=>c?.[h]===null||!!c?.[h],a=H0.filter(([c])=>V0.has(c)||o(t,c)||o(e?.run.picture.energy,c));this.#t.replaceChildren(...e?[N("tr",{},N("td",{}),N("th",{scope:"col"},"now"),N("th",{scope:"col"},e.label))]:[],...a.map(([c,h])=>N("tr",{class:c==="final"?"total":""},N("th",{scope:"row"},h),N("td",{},r(t,c)),...e?[N("td",{},r(e.run.picture.energy,c))]:[])));let l=t.error;this.#e.textContent=l===void 0?"":`The account closes to ${Ri(l??NaN,2)} of the largest energy.`}};var wS=.04,Mc=class extends Ys{#t;constructor(t,e=new Sc){super(t,160,e.root),this.#t=e}course(t){let{run:e}=t,n=Ki(t),s=e.curve("energy",0,n),r=xo(t,"energy",null),o=e.largest("energy",0,n),a=new Je(o||1,"J"),l=d=>a.text(d);this.#t.fill(e.picture.energy,t.pinned);let c=[];r&&c.push({label:t.pinned.label,token:"ink",...r,...qs,says:l}),c.push({label:r?"structure, now":"structure",token:"ink",values:s.values,says:l});let h=n===null?null:e.trial(n);h&&c.push({label:"barrier",token:"constraint",values:h.column("barrier",0),dash:[6,4],says:l});let[,u]=ys(c.map(({values:d})=>d));return{time:s.time,lines:c,measure:a,y:[-wS*u,u],heading:["Energy",`[${a.unit}]`],caption:`Largest ${a.text(o)} ${vo(n)}.`}}};var TS=new Float32Array(2).fill(NaN),wc=class{card;#t;#e=zs();#n;#i;#s;#a=null;#o=null;#r=1;#l="";constructor(t,e,n){this.#n=t.look,this.#i=n,this.#s=Yi(e,n).token,this.#t=new Ji(this.#e,{look:t.look,height:290,dot:this.#s,xTitle:()=>`command [${this.#l}]`,over:s=>this.#c(s)}),this.card=new ji(this.#t.legend.root),this.card.body.append(this.#e)}draw(t){let{run:e,pinned:n,trial:s}=t,r=e.ports[this.#i];this.#r=e.picture.gains[this.#i]??1;let o=e.trial(s);this.#a=o&&{command:o.column("command",this.#i),delivered:o.column("delivered",this.#i)};let a=n?Ca(n,r):-1,l=a>=0?n?.run.trial(s):null;this.#o=l?{command:l.column("command",a),delivered:l.column("delivered",a)}:null;let c=[this.#a,this.#o].filter(x=>x!==null),h=ys(c.map(({command:x})=>x)),u=ys(c.map(({delivered:x})=>x)),d=new Je(Math.max(-h[0],h[1],-u[0],u[1]),r.effort_unit);this.#l=d.unit;let f=[{label:`gain ${Ri(this.#r)}`,token:"faint",dash:[5,3],width:1},...this.#o?[{label:n.label,token:this.#s,dash:[4,3],width:1,alpha:.65}]:[],{label:this.#o?"now":"delivered",token:this.#s}];this.#t.draw(Float64Array.of(...h),f.map(x=>({...x,values:TS})),{x:h,y:u,factor:d.factor,xFactor:d.factor}),this.card.title(`${ps(vr(r))} loop`,`delivered [${d.unit}]`);let p=o?`Trial ${s}: ${ES(this.#a,this.#r,r.effort_unit)}.`:`Trial ${s} is on its way.`;this.card.caption(p),$i(this.#e,`Delivered against commanded ${vr(r)}. ${p}`)}cursor(t){let e=t.run.trial(t.trial);this.#t.point(e&&[e.at("command",this.#i,t.time),e.at("delivered",this.#i,t.time)])}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}#c(t){let{ctx:e,bbox:n}=t,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(n.left,n.top,n.width,n.height),e.clip();let[r,o]=[t.scales.x.min,t.scales.x.max];df(t,{command:Float32Array.of(r,o),delivered:Float32Array.of(r*this.#r,o*this.#r)},this.#n.colour("faint"),s,[5*s,3*s]),e.globalAlpha=.65,this.#o&&df(t,this.#o,this.#n.colour(this.#s),s,[4*s,3*s]),e.globalAlpha=1,this.#a&&df(t,this.#a,this.#n.colour(this.#s),1.4*s,[]),e.restore()}};function df(i,{command:t,delivered:e},n,s,r){let{ctx:o}=i,a=t.map(c=>i.valToPos(c,"x",!0)),l=e.map(c=>i.valToPos(c,"y",!0));o.strokeStyle=n,o.lineWidth=s,o.setLineDash(r),o.stroke(D0(a,l))}function ES({command:i,delivered:t},e,n){let s=0;for(let r=0;r<i.length;r++)s=Math.max(s,Math.abs(t[r]-e*i[r]));return`up to ${new Je(s,n).text(s)} off the line of gain ${Ri(e)}`}var AS=1.7,G0={label:"constraint",token:"constraint",dash:[6,4],width:1.2},Tc=class extends Ys{#t;#e;#n={low:null,high:null};constructor(t,e){super(t,190),this.#t=t.look,this.#e=e}course(t){let{run:e}=t,n=e.ports[this.#e],s=Yi(e.ports,this.#e),r=Ki(t),o=e.curve("y",this.#e,r),a=xo(t,"y",n),l=e.largest("y",this.#e,r),c=new Je(l||1,n.motion_unit),h=p=>c.text(p);this.#n=this.#i(e,r,Math.max(l,a?ys([a.values])[1]:0));let u=[];if(a&&u.push({label:t.pinned.label,token:s.token,...a,...qs,says:h}),e.picture.tracking){let{values:p}=e.curve("reference",this.#e,r);u.push({label:"reference",token:"reference",values:p,dash:[1.5,2.5],says:h})}let{low:d,high:f}=this.#n;return d&&u.push({...G0,values:d.values}),f&&u.push({...G0,values:f.values,unlisted:d!==null}),u.push({label:a?"now":va(n),token:s.token,values:o.values,dash:s.dash,says:h}),{time:o.time,lines:u,measure:c,heading:[ps(xr(n)),`${va(n)} [${c.unit}]`],caption:this.#s(t,n,c)}}under(t){this.#n.high&&uf(t,this.#t,this.#n.high,1),this.#n.low&&uf(t,this.#t,this.#n.low,-1)}#i(t,e,n){let s=r=>{let o=t.curve(r,this.#e,e);return o.values.reduce((l,c)=>Math.min(l,Math.abs(c)),1/0)<AS*n?o:null};return{low:s("low"),high:s("high")}}#s(t,e,n){let{run:s}=t,r=Ki(t),o=`Largest ${n.text(s.largest("y",this.#e,r))} ${vo(r)}`,a=["low","high"].map(d=>s.curve(d,this.#e,r).values),[l,c]=a.map(d=>d[0]);if(l===-1/0&&c===1/0)return`${o}; no constraint.`;if(a.some(d=>d.some(f=>f!==d[0])))return`${o}; the constraint moves.`;let h=new Je(Math.max(...[l,c].map(Math.abs).filter(Number.isFinite)),e.motion_unit),u=l===-c?`±${h.text(c)}`:`${h.number(l)} … ${h.text(c)}`;return`${o}; constraint ${u}${this.#n.low||this.#n.high?"":" (beyond the plot)"}.`}};var RS=500,Ec=class{root=N("div",{class:"unseen"});#t=[];#e="";fill(t){let{trials:e,ports:n}=t.picture,s=[e,...n.map(({name:r})=>r)].join();s!==this.#e&&(this.#e=s,this.#n(t)),this.#t.forEach(({cell:r,trial:o,port:a})=>{let l=t.peak(o,a);r.dataset.value=String(l),le(r,ba(l,n[a].motion_unit))})}#n({picture:{trials:t,ports:e}}){this.#t=[];let n=N("tr",{},N("th",{scope:"col"},"Trial"),...e.map(l=>N("th",{scope:"col"},`Largest ${xr(l)}`))),s=Math.ceil(t/RS),r=Array.from({length:Math.ceil(t/s)||0},(l,c)=>c*s);t>0&&r.at(-1)!==t-1&&r.push(t-1);let o=r.map(l=>{let c=e.map(h=>N("td",{"data-port":h.name,"data-trial":String(l)}));return this.#t.push(...c.map((h,u)=>({cell:h,trial:l,port:u}))),N("tr",{},N("th",{scope:"row"},String(l)),...c)}),a=N("caption",{},s>1?`Peaks of one trial in ${s}, and of the last`:"Peaks of every trial");this.root.replaceChildren(N("table",{"data-role":"peaks"},a,N("thead",{},n),N("tbody",{},...o)))}};var Ac=class{card;#t;#e=zs();#n=new Ec;constructor(t){this.#t=new Ji(this.#e,{look:t.look,height:190,xTitle:"trial",log:!0,whole:!0,seek:e=>t.jump(Math.round(e))}),this.card=new ji(this.#t.legend.root),this.card.body.append(this.#e,this.#n.root)}draw({run:t,pinned:e}){let{trials:n}=t.picture,s=Math.max(n,e?.run.picture.trials??0),r=[];t.ports.forEach((h,u)=>{let d=Yi(t.ports,u),f=m=>ba(m,h.motion_unit),p=e?Ca(e,h):-1;if(e&&p>=0){let m=Float64Array.from({length:s},(g,v)=>e.run.peak(v,p));r.unshift({label:e.label,token:d.token,values:m,...qs,marker:d.marker,unlisted:u>0})}let x=Float64Array.from({length:s},(m,g)=>t.peak(g,u));r.push({label:xr(h),token:d.token,values:x,marker:d.marker,says:f})});let o=Float64Array.from({length:s},(h,u)=>u);this.#t.draw(o,r,{x:[-.5,s-.5],y:F0(r.map(({values:h})=>h))}),this.#n.fill(t);let a=[...new Set(t.ports.map(({motion_unit:h})=>`[${h}]`))].join(", ");this.card.title(t.picture.tracking?"Largest tracking error of each trial":"Peak of each trial",a);let l=(h,u)=>`${ba(t.peak(h,u),t.ports[u].motion_unit)} in trial ${h}`,c=t.ports.map((h,u)=>`${xr(h)} ${l(0,u)}, ${l(n-1,u)}`);this.card.caption(n>0?`${ps(c[0]??"")}.`:"No trial has been finished."),$i(this.#e,`Peaks on a logarithmic axis against trials. ${c.map(ps).join(". ")}.`)}cursor({trial:t}){this.#t.cursor(t)}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}};var Rc=class{root;#t=N("canvas",{width:256,height:1});#e=this.#t.getContext("2d");#n=new ImageData(256,1);#i=N("span",{});#s=N("span",{});constructor(){this.root=N("div",{class:"colour-bar","aria-hidden":"true"},this.#i,this.#t,this.#s)}draw(t,e,n){new Uint32Array(this.#n.data.buffer).set(n),this.#e?.putImageData(this.#n,0,0),le(this.#i,e.number(-t)),le(this.#s,`+${e.text(t)}`)}};var CS=[[5,48,97],[33,102,172],[67,147,195],[146,197,222],[209,229,240],[247,247,247],[253,219,199],[244,165,130],[214,96,77],[178,24,43],[103,0,31]],PS=[[166,216,250],[110,182,235],[66,142,204],[42,98,148],[31,58,86],[29,33,37],[84,46,38],[148,66,50],[206,96,74],[240,144,118],[255,200,180]],Pa=256;function ff(i){let t=i?PS:CS;return Uint32Array.from({length:Pa},(e,n)=>{let s=n/(Pa-1)*(t.length-1),r=Math.min(Math.floor(s),t.length-2),[o,a]=[t[r],t[r+1]],[l,c,h]=o.map((u,d)=>Math.round(u+(s-r)*(a[d]-u)));return 255<<24|h<<16|c<<8|l})}function W0(i,t,e,n,s,r){let{width:o,height:a}=i,l=new Uint32Array(i.data.buffer),c=s>0?(Pa-1)/(2*s):0;for(let h=0;h<o;h++){let u=e.before[h]*n.places,d=e.share[h],f=d>0?u+n.places:u;for(let p=0;p<a;p++){let[x,m]=[n.before[p],n.share[p]],g=m>0?x+1:x,v=t[u+x]*(1-m)+t[u+g]*m,A=d>0?t[f+x]*(1-m)+t[f+g]*m:v,S=(v+d*(A-v)+s)*c;l[(a-1-p)*o+h]=r[S<0?0:S>Pa-1?Pa-1:S|0]}}}function pf(i,t){let e=i.length-1,[n,s]=[i[0],i[e]-i[0]],r=1/0;for(let h=0;h<e;h++)r=Math.min(r,i[h+1]-i[h]);let o=s>0?Math.max(1,Math.min(Math.round(s/r),t-1)):0,a=new Int32Array(o+1),l=new Float32Array(o+1);for(let h=0,u=0;h<=o;h++){let d=n+(o>0?h/o*s:0);for(;u<e-1&&i[u+1]<=d;)u++;a[h]=u,l[h]=e>0?Math.min((d-i[u])/(i[u+1]-i[u]),1):0}let c=o>0?s/o/2:0;return{places:i.length,before:a,share:l,low:n-c,high:i[e]+c}}var[IS,LS]=[2048,256],DS=new Float32Array(2).fill(NaN),Ia=class{root=zs();#t;#e=document.createElement("canvas");#n=this.#e.getContext("2d");#i=null;#s=null;#a=null;#o=null;constructor(t,e,n,s){this.#t=new Ji(this.root,{look:t,height:e,xTitle:"time t [s]",seek:n,under:r=>this.#l(r),hover:r=>this.#r(r,s)})}draw(t,e,n,s,r,o){if(t.time.length===0||t.place.length===0)return;let[a,l]=[pf(t.time,IS),pf(t.place,LS)],[c,h]=[a.before.length,l.before.length];(!this.#s||this.#s.width!==c||this.#s.height!==h)&&(this.#e.width=c,this.#e.height=h,this.#s=new ImageData(c,h)),W0(this.#s,t.values,a,l,s,r),this.#n?.putImageData(this.#s,0,0),[this.#i,this.#a,this.#o]=[t,a,l],this.#t.draw(Float64Array.of(0,n),[{label:"",token:"ink",values:DS}],{x:[0,n],y:[0,e]}),$i(this.root,o)}cursor(t){this.#t.cursor(t)}destroy(){this.#t.destroy()}#r(t,e){if(!t||!this.#i)return e(NaN,NaN,NaN);let{values:n,time:s,place:r}=this.#i,[o,a]=[_a(s,t[0]),_a(r,t[1])];if(o<0||a<0)return e(NaN,NaN,NaN);e(n[o*r.length+a],s[o],r[a])}#l(t){if(!this.#i||!this.#a||!this.#o)return;let{ctx:e,bbox:n}=t,[s,r]=[this.#a.low,this.#a.high].map(l=>t.valToPos(l,"x",!0)),[o,a]=[this.#o.low,this.#o.high].map(l=>t.valToPos(l,"y",!0));e.save(),e.beginPath(),e.rect(n.left,n.top,t.valToPos(this.#i.end,"x",!0)-n.left,n.height),e.clip(),e.imageSmoothingEnabled=!0,e.drawImage(this.#e,s,a,r-s,o-a),e.restore()}};var Cc=class{card;#t;#e=new Rc;#n=N("select",{"aria-label":"Field to be seen"});#i;#s;#a=N("p",{class:"card-note"});#o=null;#r="";#l="";#c=new Je(1,"");#h;constructor(t,e){this.#t=t,this.#h=ff(t.look.dark);let n=(s,r,o)=>this.#u(s,r,o);this.#i=new Ia(t.look,170,t.seek,n),this.#s=new Ia(t.look,150,t.seek,n),this.#n.append(...e.map(({name:s})=>N("option",{value:s},`${ao(s)}(x, t)`))),this.#n.onchange=()=>this.#o&&(this.draw(this.#o),this.cursor(this.#o)),this.card=new ji(N("div",{class:"card-tools"},...e.length>1?[this.#n]:[],this.#e.root)),this.card.body.append(this.#i.root,this.#a,this.#s.root)}draw(t){this.#o=t;let{run:e,pinned:n,trial:s,span:r}=t,{name:o,unit:a}=e.picture.fields.find(p=>p.name===this.#n.value)??e.picture.fields[0],l=n?.run.picture.fields.some(p=>p.name===o)?n:null,c=r==="trial"?s:null,h=Math.max(e.largestOfField(o,c),l?.run.largestOfField(o,c)??0),u=new Je(h||1,a),d=`${ao(o)}(x, t) ${c===null?"in all trials":`in trial ${s}`}`,f=`Largest ${u.text(e.largestOfField(o,c))} ${c===null?"in all trials":`in trial ${s}`}`;if(this.#e.draw(h,u,this.#h),this.#i.draw(X0(e,o,c),e.picture.span,Ar(t),h,this.#h,`${d} as a map of time and place. ${f}.`),this.#s.root.hidden=this.#a.hidden=!l,l){this.#a.textContent=`${l.label}, same colours`;let p=X0(l.run,o,c);this.#s.draw(p,l.run.picture.span,Ar(t),h,this.#h,`${d} of ${l.label}.`)}this.card.title(`Shape ${ao(o)}(x, t) over place x [m] and time`,`[${u.unit}]`),[this.#r,this.#l,this.#c]=[`${f}.`,ao(o),u],this.card.caption(this.#r)}#u(t,e,n){let s=`${this.#l} = ${this.#c.text(t)} at x = ${Ri(n)} m, t = ${Ri(e)} s`;this.card.caption(Number.isNaN(t)?this.#r:s)}cursor(t){this.#i.cursor($s(t)),t.pinned&&this.#s.cursor($s(t))}repaint(){this.#h=ff(this.#t.look.dark),this.#o&&this.draw(this.#o)}destroy(){this.#i.destroy(),this.#s.destroy()}};function X0(i,t,e){let{duration:n,trials:s}=i.picture;return{...i.field(t,e),place:i.x,end:e===null?n*s:n}}var Pc=class{#t;#e;#n;#i=[];#s="";#a=null;constructor(t,e){this.#t=t,this.#e=e,this.#t.classList.add("panels"),this.#n=new IntersectionObserver(n=>this.#l(n),{rootMargin:"80px"})}draw(t){this.#a=t,this.#r(t.run);for(let e of this.#i)e.stale=!0,this.#o(e)}cursor(t){this.#a=t;for(let{panel:e,seen:n,stale:s}of this.#i)n&&!s&&e.cursor(t)}repaint(){for(let{panel:t}of this.#i)t.repaint()}#o(t){!t.seen||!t.stale||!this.#a||(t.stale=!1,t.panel.draw(this.#a),t.panel.cursor(this.#a))}#r({picture:{ports:t,fields:e,gains:n}}){let s=c=>n[c]!==0,r=JSON.stringify([t,e,t.map((c,h)=>s(h))]);if(r===this.#s)return;this.#s=r;for(let{panel:c}of this.#i)c.destroy();this.#n.disconnect();let o=t.map((c,h)=>h),a=o.filter(s),l=[new Ac(this.#e),...o.map(c=>new Tc(this.#e,c)),...a.map(c=>new bc(this.#e,c)),...e.length>0?[new Cc(this.#e,e)]:[],...a.map(c=>new wc(this.#e,t,c)),new Mc(this.#e)];this.#i=l.map(c=>({panel:c,seen:!0,stale:!0})),this.#t.replaceChildren(...l.map(({card:c})=>c.root));for(let c of l)this.#n.observe(c.card.root)}#l(t){for(let{target:e,isIntersecting:n}of t){let s=this.#i.find(({panel:r})=>r.card.root===e);s&&(s.seen=n,this.#o(s),s.seen&&this.#a&&s.panel.cursor(this.#a))}}};function q0(i){document.addEventListener("keydown",t=>{let e=i[t.key];!e||t.ctrlKey||t.altKey||t.metaKey||t.defaultPrevented||NS(t.target)||t.key===" "&&FS(t.target)||(t.preventDefault(),e())})}function NS(i){return i instanceof HTMLInputElement?!["range","checkbox","radio","button"].includes(i.type):i instanceof HTMLTextAreaElement||i instanceof HTMLSelectElement||i instanceof HTMLElement&&i.isContentEditable}function FS(i){return i instanceof Element&&i.closest("button, summary, a, [type=checkbox], [type=radio]")!==null}var or={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ar={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},wy=0,$f=1,Ty=2;var dl=1,Ey=2,$o=3,lr=0,Zn=1,ss=2,Fr=0,Yo=1,Yf=2,Zf=3,Jf=4,Ay=5;var Ur=100,Ry=101,Cy=102,Py=103,Iy=104,Ly=200,Dy=201,Ny=202,Fy=203,Kf=204,jf=205,Uy=206,Oy=207,ky=208,By=209,zy=210,Hy=211,Vy=212,Gy=213,Wy=214,sh=0,rh=1,oh=2,Uo=3,ah=4,lh=5,ch=6,hh=7,Gh=0,Xy=1,qy=2,rs=0,Qf=1,tp=2,ep=3,np=4,ip=5,sp=6,rp=7;var op=300,Or=301,Zo=302,Wh=303,Xh=304,uh=1e3,ts=1001,dh=1002,Cn=1003,$y=1004;var fl=1005;var Yn=1006,qh=1007;var Is=1008;var jn=1009,ap=1010,lp=1011,Jo=1012,$h=1013,Ui=1014,Oi=1015,ki=1016,Yh=1017,Zh=1018,kr=1020,cp=35902,hp=35899,up=1021,dp=1022,Bi=1023,Ts=1026,Ls=1027,fp=1028,Jh=1029,cr=1030,Kh=1031;var jh=1033,pl=33776,ml=33777,gl=33778,yl=33779,Qh=35840,tu=35841,eu=35842,nu=35843,iu=36196,su=37492,ru=37496,ou=37488,au=37489,_l=37490,lu=37491,cu=37808,hu=37809,uu=37810,du=37811,fu=37812,pu=37813,mu=37814,gu=37815,yu=37816,_u=37817,xu=37818,vu=37819,bu=37820,Su=37821,Mu=36492,wu=36494,Tu=36495,Eu=36283,Au=36284,xl=36285,Ru=36286;var Ha=2300,fh=2301,nh=2302,zf=2303,Hf=2400,Vf=2401,Gf=2402;var Yy=3200;var Cu=0,Zy=1,Ds="",ci="srgb",Va="srgb-linear",Ga="linear",Ee="srgb";var ih=7680;var Jy=519,Ky=512,jy=513,Qy=514,pp=515,t_=516,e_=517,mp=518,gp=519,n_=35044,yp=35048;var _p="300 es",vi=2e3,Oo=2001;function US(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function OS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Wa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function i_(){let i=Wa("canvas");return i.style.display="block",i}var $0={},ko=null;function xp(...i){let t="THREE."+i.shift();ko?ko("log",t,...i):console.log(t,...i)}function s_(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $t(...i){i=s_(i);let t="THREE."+i.shift();if(ko)ko("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Qt(...i){i=s_(i);let t="THREE."+i.shift();if(ko)ko("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Oa(...i){let t=i.join(" ");t in $0||($0[t]=!0,$t(...i))}function r_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var o_={[sh]:sh,[oh]:ch,[ah]:ah,[Uo]:lh,[rh]:rh,[ch]:oh,[hh]:hh,[lh]:Uo},Fi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Y0=1234567,No=Math.PI/180,Bo=180/Math.PI;function Ko(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]+"-"+On[t&255]+On[t>>8&255]+"-"+On[t>>16&15|64]+On[t>>24&255]+"-"+On[e&63|128]+On[e>>8&255]+"-"+On[e>>16&255]+On[e>>24&255]+On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]).toLowerCase()}function ce(i,t,e){return Math.max(t,Math.min(e,i))}function vp(i,t){return(i%t+t)%t}function kS(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function BS(i,t,e){return i!==t?(e-i)/(t-i):0}function ka(i,t,e){return(1-e)*i+e*t}function zS(i,t,e,n){return ka(i,t,1-Math.exp(-e*n))}function HS(i,t=1){return t-Math.abs(vp(i,t*2)-t)}function VS(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function GS(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function WS(i,t){return i+Math.floor(Math.random()*(t-i+1))}function XS(i,t){return i+Math.random()*(t-i)}function qS(i){return i*(.5-Math.random())}function $S(i){i!==void 0&&(Y0=i);let t=Y0+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function YS(i){return i*No}function ZS(i){return i*Bo}function JS(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function KS(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function bp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function jS(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Sp(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function a_(i,t){if(t.constructor===Float32Array)return i;let e=Sp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function l_(i,t){if(t.constructor===Float32Array)return i;let e=Sp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Mp={DEG2RAD:No,RAD2DEG:Bo,generateUUID:Ko,clamp:ce,euclideanModulo:vp,mapLinear:kS,inverseLerp:BS,lerp:ka,damp:zS,pingpong:HS,smoothstep:VS,smootherstep:GS,randInt:WS,randFloat:XS,randFloatSpread:qS,seededRandom:$S,degToRad:YS,radToDeg:ZS,isPowerOfTwo:JS,ceilPowerOfTwo:KS,floorPowerOfTwo:bp,setQuaternionFromProperEuler:jS,normalize:l_,denormalize:a_},Ot=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ce(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ui=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),A=Math.sin(v);g=Math.sin(g*v)/A,a=Math.sin(a*v)/A,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Z0.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Z0.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return mf.copy(this).projectOnVector(t),this.sub(mf)}reflect(t){return this.sub(mf.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ce(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},mf=new z,Z0=new ui,te=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],v=s[1],A=s[4],S=s[7],C=s[2],E=s[5],_=s[8];return r[0]=o*x+a*v+l*C,r[3]=o*m+a*A+l*E,r[6]=o*g+a*S+l*_,r[1]=c*x+h*v+u*C,r[4]=c*m+h*A+u*E,r[7]=c*g+h*S+u*_,r[2]=d*x+f*v+p*C,r[5]=d*m+f*A+p*E,r[8]=d*g+f*S+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Oa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(gf.makeScale(t,e)),this}rotate(t){return Oa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(gf.makeRotation(-t)),this}translate(t,e){return Oa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(gf.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},gf=new te,J0=new te().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),K0=new te().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function QS(){let i={enabled:!0,workingColorSpace:Va,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ee&&(s.r=ws(s.r),s.g=ws(s.g),s.b=ws(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ee&&(s.r=Fo(s.r),s.g=Fo(s.g),s.b=Fo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ds?Ga:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Va]:{primaries:t,whitePoint:n,transfer:Ga,toXYZ:J0,fromXYZ:K0,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:t,whitePoint:n,transfer:Ee,toXYZ:J0,fromXYZ:K0,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),i}var _e=QS();function ws(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Fo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var bo,ph=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{bo===void 0&&(bo=Wa("canvas")),bo.width=t.width,bo.height=t.height;let s=bo.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=bo}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Wa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ws(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ws(e[n]/255)*255):e[n]=ws(e[n]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},tM=0,zo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:tM++}),this.uuid=Ko(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(yf(s[o].image)):r.push(yf(s[o]))}else r=yf(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function yf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ph.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var eM=0,_f=new z,Kn=class i extends Fi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ts,s=ts,r=Yn,o=Is,a=Bi,l=jn,c=i.DEFAULT_ANISOTROPY,h=Ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:eM++}),this.uuid=Ko(),this.name="",this.source=new zo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ot(0,0),this.repeat=new Ot(1,1),this.center=new Ot(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new te,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_f).x}get height(){return this.source.getSize(_f).y}get depth(){return this.source.getSize(_f).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==op)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case uh:t.x=t.x-Math.floor(t.x);break;case ts:t.x=t.x<0?0:1;break;case dh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case uh:t.y=t.y-Math.floor(t.y);break;case ts:t.y=t.y<0?0:1;break;case dh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=op;Kn.DEFAULT_ANISOTROPY=1;var Ye=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,S=(f+1)/2,C=(g+1)/2,E=(h+d)/4,_=(u+x)/4,T=(p+m)/4;return A>S&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=_/n):S>C?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=E/s,r=T/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=T/r),this.set(n,s,r,e),this}let v=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(u-x)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},mh=class extends Fi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ye(0,0,t,e),this.scissorTest=!1,this.viewport=new Ye(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new zo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends mh{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Xa=class extends Kn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var gh=class extends Kn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Oe=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/So.setFromMatrixColumn(t,0).length(),r=1/So.setFromMatrixColumn(t,1).length(),o=1/So.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(nM,t,iM)}lookAt(t,e,n){let s=this.elements;return ai.subVectors(t,e),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),Zs.crossVectors(n,ai),Zs.lengthSq()===0&&(Math.abs(n.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),Zs.crossVectors(n,ai)),Zs.normalize(),Ic.crossVectors(ai,Zs),s[0]=Zs.x,s[4]=Ic.x,s[8]=ai.x,s[1]=Zs.y,s[5]=Ic.y,s[9]=ai.y,s[2]=Zs.z,s[6]=Ic.z,s[10]=ai.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],v=n[3],A=n[7],S=n[11],C=n[15],E=s[0],_=s[4],T=s[8],k=s[12],F=s[1],D=s[5],H=s[9],W=s[13],L=s[2],X=s[6],Y=s[10],G=s[14],ct=s[3],K=s[7],Q=s[11],st=s[15];return r[0]=o*E+a*F+l*L+c*ct,r[4]=o*_+a*D+l*X+c*K,r[8]=o*T+a*H+l*Y+c*Q,r[12]=o*k+a*W+l*G+c*st,r[1]=h*E+u*F+d*L+f*ct,r[5]=h*_+u*D+d*X+f*K,r[9]=h*T+u*H+d*Y+f*Q,r[13]=h*k+u*W+d*G+f*st,r[2]=p*E+x*F+m*L+g*ct,r[6]=p*_+x*D+m*X+g*K,r[10]=p*T+x*H+m*Y+g*Q,r[14]=p*k+x*W+m*G+g*st,r[3]=v*E+A*F+S*L+C*ct,r[7]=v*_+A*D+S*X+C*K,r[11]=v*T+A*H+S*Y+C*Q,r[15]=v*k+A*W+S*G+C*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],v=l*f-c*d,A=a*f-c*u,S=a*d-l*u,C=o*f-c*h,E=o*d-l*h,_=o*u-a*h;return e*(x*v-m*A+g*S)-n*(p*v-m*C+g*E)+s*(p*A-x*C+g*_)-r*(p*S-x*E+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],v=e*a-n*o,A=e*l-s*o,S=e*c-r*o,C=n*l-s*a,E=n*c-r*a,_=s*c-r*l,T=h*x-u*p,k=h*m-d*p,F=h*g-f*p,D=u*m-d*x,H=u*g-f*x,W=d*g-f*m,L=v*W-A*H+S*D+C*F-E*k+_*T;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/L;return t[0]=(a*W-l*H+c*D)*X,t[1]=(s*H-n*W-r*D)*X,t[2]=(x*_-m*E+g*C)*X,t[3]=(d*E-u*_-f*C)*X,t[4]=(l*F-o*W-c*k)*X,t[5]=(e*W-s*F+r*k)*X,t[6]=(m*S-p*_-g*A)*X,t[7]=(h*_-d*S+f*A)*X,t[8]=(o*H-a*F+c*T)*X,t[9]=(n*F-e*H-r*T)*X,t[10]=(p*E-x*S+g*v)*X,t[11]=(u*S-h*E-f*v)*X,t[12]=(a*k-o*D-l*T)*X,t[13]=(e*D-n*k+s*T)*X,t[14]=(x*A-p*C-m*v)*X,t[15]=(h*C-u*A+d*v)*X,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,v=l*c,A=l*h,S=l*u,C=n.x,E=n.y,_=n.z;return s[0]=(1-(x+g))*C,s[1]=(f+S)*C,s[2]=(p-A)*C,s[3]=0,s[4]=(f-S)*E,s[5]=(1-(d+g))*E,s[6]=(m+v)*E,s[7]=0,s[8]=(p+A)*_,s[9]=(m-v)*_,s[10]=(1-(d+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=So.set(s[0],s[1],s[2]).length(),a=So.set(s[4],s[5],s[6]).length(),l=So.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Li.copy(this);let c=1/o,h=1/a,u=1/l;return Li.elements[0]*=c,Li.elements[1]*=c,Li.elements[2]*=c,Li.elements[4]*=h,Li.elements[5]*=h,Li.elements[6]*=h,Li.elements[8]*=u,Li.elements[9]*=u,Li.elements[10]*=u,e.setFromRotationMatrix(Li),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=vi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===vi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Oo)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=vi,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===vi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Oo)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},So=new z,Li=new Oe,nM=new z(0,0,0),iM=new z(1,1,1),Zs=new z,Ic=new z,ai=new z,j0=new Oe,Q0=new ui,Es=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ce(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return j0.makeRotationFromQuaternion(t),this.setFromRotationMatrix(j0,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Q0.setFromEuler(this),this.setFromQuaternion(Q0,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Es.DEFAULT_ORDER="XYZ";var qa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},sM=0,ty=new z,Mo=new ui,_s=new Oe,Lc=new z,La=new z,rM=new z,oM=new ui,ey=new z(1,0,0),ny=new z(0,1,0),iy=new z(0,0,1),sy={type:"added"},aM={type:"removed"},wo={type:"childadded",child:null},xf={type:"childremoved",child:null},Nn=class i extends Fi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:sM++}),this.uuid=Ko(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new z,e=new Es,n=new ui,s=new z(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Oe},normalMatrix:{value:new te}}),this.matrix=new Oe,this.matrixWorld=new Oe,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new qa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Mo.setFromAxisAngle(t,e),this.quaternion.multiply(Mo),this}rotateOnWorldAxis(t,e){return Mo.setFromAxisAngle(t,e),this.quaternion.premultiply(Mo),this}rotateX(t){return this.rotateOnAxis(ey,t)}rotateY(t){return this.rotateOnAxis(ny,t)}rotateZ(t){return this.rotateOnAxis(iy,t)}translateOnAxis(t,e){return ty.copy(t).applyQuaternion(this.quaternion),this.position.add(ty.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(ey,t)}translateY(t){return this.translateOnAxis(ny,t)}translateZ(t){return this.translateOnAxis(iy,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(_s.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Lc.copy(t):Lc.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),La.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_s.lookAt(La,Lc,this.up):_s.lookAt(Lc,La,this.up),this.quaternion.setFromRotationMatrix(_s),s&&(_s.extractRotation(s.matrixWorld),Mo.setFromRotationMatrix(_s),this.quaternion.premultiply(Mo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(sy),wo.child=t,this.dispatchEvent(wo),wo.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(aM),xf.child=t,this.dispatchEvent(xf),xf.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),_s.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),_s.multiply(t.parent.matrixWorld)),t.applyMatrix4(_s),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(sy),wo.child=t,this.dispatchEvent(wo),wo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,t,rM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,oM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new z(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ke=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},lM={type:"move"},Ho=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ke,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ke,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ke,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(lM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ke;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},c_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Js={h:0,s:0,l:0},Dc={h:0,s:0,l:0};function vf(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ci){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=n,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=_e.workingColorSpace){if(t=vp(t,1),e=ce(e,0,1),n=ce(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=vf(o,r,t+1/3),this.g=vf(o,r,t),this.b=vf(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=ci){function n(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ci){let n=c_[t.toLowerCase()];return n!==void 0?this.setHex(n,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ws(t.r),this.g=ws(t.g),this.b=ws(t.b),this}copyLinearToSRGB(t){return this.r=Fo(t.r),this.g=Fo(t.g),this.b=Fo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ci){return _e.workingToColorSpace(kn.copy(this),t),Math.round(ce(kn.r*255,0,255))*65536+Math.round(ce(kn.g*255,0,255))*256+Math.round(ce(kn.b*255,0,255))}getHexString(t=ci){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(kn.copy(this),e);let n=kn.r,s=kn.g,r=kn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(kn.copy(this),e),t.r=kn.r,t.g=kn.g,t.b=kn.b,t}getStyle(t=ci){_e.workingToColorSpace(kn.copy(this),t);let e=kn.r,n=kn.g,s=kn.b;return t!==ci?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Js),this.setHSL(Js.h+t,Js.s+e,Js.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Js),t.getHSL(Dc);let n=ka(Js.h,Dc.h,e),s=ka(Js.s,Dc.s,e),r=ka(Js.l,Dc.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new he;he.NAMES=c_;var $a=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Es,this.environmentIntensity=1,this.environmentRotation=new Es,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Di=new z,xs=new z,bf=new z,vs=new z,To=new z,Eo=new z,ry=new z,Sf=new z,Mf=new z,wf=new z,Tf=new Ye,Ef=new Ye,Af=new Ye,Ms=class i{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Di.subVectors(t,e),s.cross(Di);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Di.subVectors(s,e),xs.subVectors(n,e),bf.subVectors(t,e);let o=Di.dot(Di),a=Di.dot(xs),l=Di.dot(bf),c=xs.dot(xs),h=xs.dot(bf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,vs)===null?!1:vs.x>=0&&vs.y>=0&&vs.x+vs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vs.x),l.addScaledVector(o,vs.y),l.addScaledVector(a,vs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Tf.setScalar(0),Ef.setScalar(0),Af.setScalar(0),Tf.fromBufferAttribute(t,e),Ef.fromBufferAttribute(t,n),Af.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Tf,r.x),o.addScaledVector(Ef,r.y),o.addScaledVector(Af,r.z),o}static isFrontFacing(t,e,n,s){return Di.subVectors(n,e),xs.subVectors(t,e),Di.cross(xs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Di.subVectors(this.c,this.b),xs.subVectors(this.a,this.b),Di.cross(xs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;To.subVectors(s,n),Eo.subVectors(r,n),Sf.subVectors(t,n);let l=To.dot(Sf),c=Eo.dot(Sf);if(l<=0&&c<=0)return e.copy(n);Mf.subVectors(t,s);let h=To.dot(Mf),u=Eo.dot(Mf);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(To,o);wf.subVectors(t,r);let f=To.dot(wf),p=Eo.dot(wf);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Eo,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return ry.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(ry,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(n).addScaledVector(To,o).addScaledVector(Eo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},tr=class{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ni.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ni.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ni.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(t.matrixWorld),this.expandByPoint(Ni);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Nc.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Nc.copy(n.boundingBox)),Nc.applyMatrix4(t.matrixWorld),this.union(Nc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ni),Ni.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Da),Fc.subVectors(this.max,Da),Ao.subVectors(t.a,Da),Ro.subVectors(t.b,Da),Co.subVectors(t.c,Da),Ks.subVectors(Ro,Ao),js.subVectors(Co,Ro),Rr.subVectors(Ao,Co);let e=[0,-Ks.z,Ks.y,0,-js.z,js.y,0,-Rr.z,Rr.y,Ks.z,0,-Ks.x,js.z,0,-js.x,Rr.z,0,-Rr.x,-Ks.y,Ks.x,0,-js.y,js.x,0,-Rr.y,Rr.x,0];return!Rf(e,Ao,Ro,Co,Fc)||(e=[1,0,0,0,1,0,0,0,1],!Rf(e,Ao,Ro,Co,Fc))?!1:(Uc.crossVectors(Ks,js),e=[Uc.x,Uc.y,Uc.z],Rf(e,Ao,Ro,Co,Fc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ni).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ni).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(bs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},bs=[new z,new z,new z,new z,new z,new z,new z,new z],Ni=new z,Nc=new tr,Ao=new z,Ro=new z,Co=new z,Ks=new z,js=new z,Rr=new z,Da=new z,Fc=new z,Uc=new z,Cr=new z;function Rf(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Cr.fromArray(i,r);let a=s.x*Math.abs(Cr.x)+s.y*Math.abs(Cr.y)+s.z*Math.abs(Cr.z),l=t.dot(Cr),c=e.dot(Cr),h=n.dot(Cr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var pn=new z,Oc=new Ot,cM=0,bi=class extends Fi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:cM++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=n_,this.updateRanges=[],this.gpuType=Oi,this.version=0,this._normalizationScale=t!==void 0?Sp(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Oc.fromBufferAttribute(this,e),Oc.applyMatrix3(t),this.setXY(e,Oc.x,Oc.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)pn.fromBufferAttribute(this,e),pn.applyMatrix3(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)pn.fromBufferAttribute(this,e),pn.applyMatrix4(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)pn.fromBufferAttribute(this,e),pn.applyNormalMatrix(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)pn.fromBufferAttribute(this,e),pn.transformDirection(t),this.setXYZ(e,pn.x,pn.y,pn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):a_(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):l_(t,this.array)}};var Ya=class extends bi{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Za=class extends bi{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var ke=class extends bi{constructor(t,e,n){super(new Float32Array(t),e,n)}},hM=new tr,Na=new z,Cf=new z,Lr=class{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):hM.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Na.subVectors(t,this.center);let e=Na.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Na,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Cf.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Na.copy(t.center).add(Cf)),this.expandByPoint(Na.copy(t.center).sub(Cf))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},uM=0,xi=new Oe,Pf=new Nn,Po=new z,li=new tr,Fa=new tr,Rn=new z,je=class i extends Fi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uM++}),this.uuid=Ko(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(US(t)?Za:Ya)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new te().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return xi.makeRotationFromQuaternion(t),this.applyMatrix4(xi),this}rotateX(t){return xi.makeRotationX(t),this.applyMatrix4(xi),this}rotateY(t){return xi.makeRotationY(t),this.applyMatrix4(xi),this}rotateZ(t){return xi.makeRotationZ(t),this.applyMatrix4(xi),this}translate(t,e,n){return xi.makeTranslation(t,e,n),this.applyMatrix4(xi),this}scale(t,e,n){return xi.makeScale(t,e,n),this.applyMatrix4(xi),this}lookAt(t){return Pf.lookAt(t),Pf.updateMatrix(),this.applyMatrix4(Pf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Po).negate(),this.translate(Po.x,Po.y,Po.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ke(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];li.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Lr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){let n=this.boundingSphere.center;if(li.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Fa.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(li.min,Fa.min),li.expandByPoint(Rn),Rn.addVectors(li.max,Fa.max),li.expandByPoint(Rn)):(li.expandByPoint(Fa.min),li.expandByPoint(Fa.max))}li.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Rn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Rn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Rn.fromBufferAttribute(a,c),l&&(Po.fromBufferAttribute(t,c),Rn.add(Po)),s=Math.max(s,n.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new bi(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new z,l[k]=new z;let h=new z,u=new z,d=new z,f=new Ot,p=new Ot,x=new Ot,m=new z,g=new z;function v(k,F,D){c[k]=c[F]=c[D]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,F),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,k),p.fromBufferAttribute(r,F),x.fromBufferAttribute(r,D),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let H=1/(p.x*x.y-x.x*p.y);isFinite(H)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(H),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(H),a[k].add(m),a[F].add(m),a[D].add(m),l[k].add(g),l[F].add(g),l[D].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let k=0,F=A.length;k<F;++k){let D=A[k],H=D.start,W=D.count;for(let L=H,X=H+W;L<X;L+=3)v(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let S=new z,C=new z,E=new z,_=new z;function T(k){E.fromBufferAttribute(s,k),_.copy(E);let F=a[k];S.copy(F),S.sub(E.multiplyScalar(E.dot(F))).normalize(),C.crossVectors(_,F);let H=C.dot(l[k])<0?-1:1;o.setXYZW(k,S.x,S.y,S.z,H)}for(let k=0,F=n.count;k<F;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new bi(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,h=new z,u=new z;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Rn.fromBufferAttribute(t,e),Rn.normalize(),t.setXYZ(e,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new bi(d,h,u)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var If=new z,dM=new z,fM=new te,hi=class{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=If.subVectors(n,e).cross(dM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(If),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||fM.getNormalMatrix(t),s=this.coplanarPoint(If).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},pM=0,As=class extends Fi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:pM++}),this.uuid=Ko(),this.name="",this.type="Material",this.blending=Yo,this.side=lr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Kf,this.blendDst=jf,this.blendEquation=Ur,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=Uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Jy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ih,this.stencilZFail=ih,this.stencilZPass=ih,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new hi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ot().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ot().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ss=new z,Lf=new z,kc=new z,Bc=new z,Dr=class{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ss)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ss.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ss.copy(this.origin).addScaledVector(this.direction,e),Ss.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Lf.copy(t).add(e).multiplyScalar(.5),kc.copy(e).sub(t).normalize(),Bc.copy(this.origin).sub(Lf);let r=t.distanceTo(e)*.5,o=-this.direction.dot(kc),a=Bc.dot(this.direction),l=-Bc.dot(kc),c=Bc.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Lf).addScaledVector(kc,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ss.subVectors(t.center,this.origin);let n=Ss.dot(this.direction),s=Ss.dot(Ss)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ss)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=n.x-o.x,v=n.y-o.y,A=n.z-o.z,S=Math.abs(l),C=Math.abs(c),E=Math.abs(h),_,T,k,F,D,H,W,L,X,Y,G,ct;if(S>=C&&S>=E?(k=l,H=u,X=p,ct=g,l>=0?(_=c,T=h,F=d,D=f,W=x,L=m,Y=v,G=A):(_=h,T=c,F=f,D=d,W=m,L=x,Y=A,G=v)):C>=E?(k=c,H=d,X=x,ct=v,c>=0?(_=h,T=l,F=f,D=u,W=m,L=p,Y=A,G=g):(_=l,T=h,F=u,D=f,W=p,L=m,Y=g,G=A)):(k=h,H=f,X=m,ct=A,h>=0?(_=l,T=c,F=u,D=d,W=p,L=x,Y=g,G=v):(_=c,T=l,F=d,D=u,W=x,L=p,Y=v,G=g)),k===0)return null;let K=_/k,Q=T/k,st=1/k,dt=F-K*H,ut=D-Q*H,tt=W-K*X,mt=L-Q*X,_t=Y-K*ct,At=G-Q*ct,St=_t*mt-At*tt,Wt=dt*At-ut*_t,ie=tt*ut-mt*dt;if(s){if(St<0||Wt<0||ie<0)return null}else if((St<0||Wt<0||ie<0)&&(St>0||Wt>0||ie>0))return null;let Vt=St+Wt+ie;if(Vt===0)return null;let de=st*(St*H+Wt*X+ie*ct);return(Vt>0?de<0:de>0)?null:this.at(de/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Rs=class extends As{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Es,this.combine=Gh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},oy=new Oe,Pr=new Dr,zc=new Lr,ay=new z,Hc=new z,Vc=new z,Gc=new z,Df=new z,Wc=new z,ly=new z,Xc=new z,Xe=class extends Nn{constructor(t=new je,e=new Rs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Wc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Df.fromBufferAttribute(u,t),o?Wc.addScaledVector(Df,h):Wc.addScaledVector(Df.sub(e),h))}e.add(Wc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),zc.copy(n.boundingSphere),zc.applyMatrix4(r),Pr.copy(t.ray).recast(t.near),!(zc.containsPoint(Pr.origin)===!1&&(Pr.intersectSphere(zc,ay)===null||Pr.origin.distanceToSquared(ay)>(t.far-t.near)**2))&&(oy.copy(r).invert(),Pr.copy(t.ray).applyMatrix4(oy),!(n.boundingBox!==null&&Pr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Pr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let E=a.getX(S),_=a.getX(S+1),T=a.getX(S+2);s=qc(this,g,t,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let v=a.getX(m),A=a.getX(m+1),S=a.getX(m+2);s=qc(this,o,t,n,c,h,u,v,A,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let E=S,_=S+1,T=S+2;s=qc(this,g,t,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let v=m,A=m+1,S=m+2;s=qc(this,o,t,n,c,h,u,v,A,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function mM(i,t,e,n,s,r,o,a){let l;if(t.side===Zn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===lr,a),l===null)return null;Xc.copy(a),Xc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Xc);return c<e.near||c>e.far?null:{distance:c,point:Xc.clone(),object:i}}function qc(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Hc),i.getVertexPosition(l,Vc),i.getVertexPosition(c,Gc);let h=mM(i,t,e,n,Hc,Vc,Gc,ly);if(h){let u=new z;Ms.getBarycoord(ly,Hc,Vc,Gc,u),s&&(h.uv=Ms.getInterpolatedAttribute(s,a,l,c,u,new Ot)),r&&(h.uv1=Ms.getInterpolatedAttribute(r,a,l,c,u,new Ot)),o&&(h.normal=Ms.getInterpolatedAttribute(o,a,l,c,u,new z),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new z,materialIndex:0};Ms.getNormal(Hc,Vc,Gc,d.normal),h.face=d,h.barycoord=u}return h}var yh=class extends Kn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Cn,h=Cn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ir=new Lr,gM=new Ot(.5,.5),$c=new z,er=class{constructor(t=new hi,e=new hi,n=new hi,s=new hi,r=new hi,o=new hi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=vi,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],v=r[12],A=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,g-p,C-v).normalize(),s[1].setComponents(c+o,f+h,g+p,C+v).normalize(),s[2].setComponents(c+a,f+u,g+x,C+A).normalize(),s[3].setComponents(c-a,f-u,g-x,C-A).normalize(),n)s[4].setComponents(l,d,m,S).normalize(),s[5].setComponents(c-l,f-d,g-m,C-S).normalize();else if(s[4].setComponents(c-l,f-d,g-m,C-S).normalize(),e===vi)s[5].setComponents(c+l,f+d,g+m,C+S).normalize();else if(e===Oo)s[5].setComponents(l,d,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ir.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ir.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ir)}intersectsSprite(t){Ir.center.set(0,0,0);let e=gM.distanceTo(t.center);return Ir.radius=.7071067811865476+e,Ir.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ir)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if($c.x=s.normal.x>0?t.max.x:t.min.x,$c.y=s.normal.y>0?t.max.y:t.min.y,$c.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint($c)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},cy=new Oe,_h=class i{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];cy.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new er),n[s].setFromProjectionMatrix(cy,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new er),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Si=class extends As{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},xh=new z,vh=new z,hy=new Oe,Ua=new Dr,Yc=new Lr,Nf=new z,uy=new z,Cs=class extends Nn{constructor(t=new je,e=new Si){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)xh.fromBufferAttribute(e,s-1),vh.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=xh.distanceTo(vh);t.setAttribute("lineDistance",new ke(n,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Yc.copy(n.boundingSphere),Yc.applyMatrix4(s),Yc.radius+=r,t.ray.intersectsSphere(Yc)===!1)return;hy.copy(s).invert(),Ua.copy(t.ray).applyMatrix4(hy);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=h.getX(x),v=h.getX(x+1),A=Zc(this,t,Ua,l,g,v,x);A&&e.push(A)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(f),g=Zc(this,t,Ua,l,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=Zc(this,t,Ua,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=Zc(this,t,Ua,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Zc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(xh.fromBufferAttribute(a,s),vh.fromBufferAttribute(a,r),e.distanceSqToSegment(xh,vh,Nf,uy)>n)return;Nf.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Nf);if(!(c<t.near||c>t.far))return{distance:c,point:uy.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var dy=new z,fy=new z,es=class extends Cs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)dy.fromBufferAttribute(e,s),fy.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+dy.distanceTo(fy);t.setAttribute("lineDistance",new ke(n,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Ja=class extends Cs{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Ka=class extends Kn{constructor(t=[],e=Or,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ps=class extends Kn{constructor(t,e,n=Ui,s,r,o,a=Cn,l=Cn,c,h=Ts,u=1){if(h!==Ts&&h!==Ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new zo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ja=class extends Ps{constructor(t,e=Ui,n=Or,s,r,o=Cn,a=Cn,l,c=Ts){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Qa=class extends Kn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ns=class i extends je{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ke(c,3)),this.setAttribute("normal",new ke(h,3)),this.setAttribute("uv",new ke(u,2));function p(x,m,g,v,A,S,C,E,_,T,k){let F=S/_,D=C/T,H=S/2,W=C/2,L=E/2,X=_+1,Y=T+1,G=0,ct=0,K=new z;for(let Q=0;Q<Y;Q++){let st=Q*D-W;for(let dt=0;dt<X;dt++){let ut=dt*F-H;K[x]=ut*v,K[m]=st*A,K[g]=L,c.push(K.x,K.y,K.z),K[x]=0,K[m]=0,K[g]=E>0?1:-1,h.push(K.x,K.y,K.z),u.push(dt/_),u.push(1-Q/T),G+=1}}for(let Q=0;Q<T;Q++)for(let st=0;st<_;st++){let dt=d+st+X*Q,ut=d+st+X*(Q+1),tt=d+(st+1)+X*(Q+1),mt=d+(st+1)+X*Q;l.push(dt,ut,mt),l.push(ut,tt,mt),ct+=6}a.addGroup(f,ct,k),f+=ct,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var nr=class i extends je{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],m=n/2,g=0;v(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new ke(u,3)),this.setAttribute("normal",new ke(d,3)),this.setAttribute("uv",new ke(f,2));function v(){let S=new z,C=new z,E=0,_=(e-t)/n;for(let T=0;T<=r;T++){let k=[],F=T/r,D=F*(e-t)+t;for(let H=0;H<=s;H++){let W=H/s,L=W*l+a,X=Math.sin(L),Y=Math.cos(L);C.x=D*X,C.y=-F*n+m,C.z=D*Y,u.push(C.x,C.y,C.z),S.set(X,_,Y).normalize(),d.push(S.x,S.y,S.z),f.push(W,1-F),k.push(p++)}x.push(k)}for(let T=0;T<s;T++)for(let k=0;k<r;k++){let F=x[k][T],D=x[k+1][T],H=x[k+1][T+1],W=x[k][T+1];(t>0||k!==0)&&(h.push(F,D,W),E+=3),(e>0||k!==r-1)&&(h.push(D,H,W),E+=3)}c.addGroup(g,E,0),g+=E}function A(S){let C=p,E=new Ot,_=new z,T=0,k=S===!0?t:e,F=S===!0?1:-1;for(let H=1;H<=s;H++)u.push(0,m*F,0),d.push(0,F,0),f.push(.5,.5),p++;let D=p;for(let H=0;H<=s;H++){let L=H/s*l+a,X=Math.cos(L),Y=Math.sin(L);_.x=k*Y,_.y=m*F,_.z=k*X,u.push(_.x,_.y,_.z),d.push(0,F,0),E.x=X*.5+.5,E.y=Y*.5*F+.5,f.push(E.x,E.y),p++}for(let H=0;H<s;H++){let W=C+H,L=D+H;S===!0?h.push(L,L+1,W):h.push(L+1,L,W),T+=3}c.addGroup(g,T,S===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Vo=class i extends nr{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Jc=new z,Kc=new z,Ff=new z,jc=new Ms,Nr=class extends je{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(No*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:m,c:g}=jc;if(x.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),jc.getNormal(Ff),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let A=(v+1)%3,S=u[v],C=u[A],E=jc[h[v]],_=jc[h[A]],T=`${S}_${C}`,k=`${C}_${S}`,F=d.get(k);F?(Ff.dot(F.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(_.x,_.y,_.z)),d.set(k,null)):d.has(T)||d.set(T,{index0:c[v],index1:c[A],normal:Ff.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;Jc.fromBufferAttribute(a,x),Kc.fromBufferAttribute(a,m),f.push(Jc.x,Jc.y,Jc.z),f.push(Kc.x,Kc.y,Kc.z)}this.setAttribute("position",new ke(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},Mi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){$t("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Ot:new z);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new z,s=[],r=[],o=[],a=new z,l=new Oe;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new z)}r[0]=new z,o[0]=new z;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ce(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(ce(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},tl=class extends Mi{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Ot){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},bh=class extends tl{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function wp(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var py=new z,my=new z,Uf=new wp,Of=new wp,kf=new wp,Go=class extends Mi{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new z){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(my.subVectors(s[0],s[1]).add(s[0]),c=my);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(py.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=py),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),m<1e-4&&(m=x),Uf.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,m),Of.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,m),kf.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,m)}else this.curveType==="catmullrom"&&(Uf.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Of.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),kf.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(Uf.calc(l),Of.calc(l),kf.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new z().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function gy(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function yM(i,t){let e=1-i;return e*e*t}function _M(i,t){return 2*(1-i)*i*t}function xM(i,t){return i*i*t}function Ba(i,t,e,n){return yM(i,t)+_M(i,e)+xM(i,n)}function vM(i,t){let e=1-i;return e*e*e*t}function bM(i,t){let e=1-i;return 3*e*e*i*t}function SM(i,t){return 3*(1-i)*i*i*t}function MM(i,t){return i*i*i*t}function za(i,t,e,n,s){return vM(i,t)+bM(i,e)+SM(i,n)+MM(i,s)}var Sh=class extends Mi{constructor(t=new Ot,e=new Ot,n=new Ot,s=new Ot){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Ot){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(za(t,s.x,r.x,o.x,a.x),za(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Mh=class extends Mi{constructor(t=new z,e=new z,n=new z,s=new z){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new z){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(za(t,s.x,r.x,o.x,a.x),za(t,s.y,r.y,o.y,a.y),za(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},wh=class extends Mi{constructor(t=new Ot,e=new Ot){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Ot){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Ot){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Th=class extends Mi{constructor(t=new z,e=new z){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new z){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new z){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Eh=class extends Mi{constructor(t=new Ot,e=new Ot,n=new Ot){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Ot){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Ba(t,s.x,r.x,o.x),Ba(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},el=class extends Mi{constructor(t=new z,e=new z,n=new z){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new z){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Ba(t,s.x,r.x,o.x),Ba(t,s.y,r.y,o.y),Ba(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ah=class extends Mi{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Ot){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(gy(a,l.x,c.x,h.x,u.x),gy(a,l.y,c.y,h.y,u.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new Ot().fromArray(s))}return this}},wM=Object.freeze({__proto__:null,ArcCurve:bh,CatmullRomCurve3:Go,CubicBezierCurve:Sh,CubicBezierCurve3:Mh,EllipseCurve:tl,LineCurve:wh,LineCurve3:Th,QuadraticBezierCurve:Eh,QuadraticBezierCurve3:el,SplineCurve:Ah});var nl=class i extends je{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let v=g*d-o;for(let A=0;A<c;A++){let S=A*u-r;p.push(S,-v,0),x.push(0,0,1),m.push(A/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let A=v+c*g,S=v+c*(g+1),C=v+1+c*(g+1),E=v+1+c*g;f.push(A,S,E),f.push(S,C,E)}this.setIndex(f),this.setAttribute("position",new ke(p,3)),this.setAttribute("normal",new ke(x,3)),this.setAttribute("uv",new ke(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var il=class i extends je{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new z,d=new z,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let v=[],A=g/n,S=o+A*a,C=t*Math.cos(S),E=Math.sqrt(t*t-C*C),_=0;g===0&&o===0?_=.5/e:g===n&&l===Math.PI&&(_=-.5/e);for(let T=0;T<=e;T++){let k=T/e,F=s+k*r;u.x=-E*Math.cos(F),u.y=C,u.z=E*Math.sin(F),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(k+_,1-A),v.push(c++)}h.push(v)}for(let g=0;g<n;g++)for(let v=0;v<e;v++){let A=h[g][v+1],S=h[g][v],C=h[g+1][v],E=h[g+1][v+1];(g!==0||o>0)&&f.push(A,S,E),(g!==n-1||l<Math.PI)&&f.push(S,C,E)}this.setIndex(f),this.setAttribute("position",new ke(p,3)),this.setAttribute("normal",new ke(x,3)),this.setAttribute("uv",new ke(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var sl=class i extends je{constructor(t=new el(new z(-1,-1,0),new z(-1,1,0),new z(1,1,0)),e=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:n,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new z,l=new z,c=new Ot,h=new z,u=[],d=[],f=[],p=[];x(),this.setIndex(p),this.setAttribute("position",new ke(u,3)),this.setAttribute("normal",new ke(d,3)),this.setAttribute("uv",new ke(f,2));function x(){for(let A=0;A<e;A++)m(A);m(r===!1?e:0),v(),g()}function m(A){h=t.getPointAt(A/e,h);let S=o.normals[A],C=o.binormals[A];for(let E=0;E<=s;E++){let _=E/s*Math.PI*2,T=Math.sin(_),k=-Math.cos(_);l.x=k*S.x+T*C.x,l.y=k*S.y+T*C.y,l.z=k*S.z+T*C.z,l.normalize(),d.push(l.x,l.y,l.z),a.x=h.x+n*l.x,a.y=h.y+n*l.y,a.z=h.z+n*l.z,u.push(a.x,a.y,a.z)}}function g(){for(let A=1;A<=e;A++)for(let S=1;S<=s;S++){let C=(s+1)*(A-1)+(S-1),E=(s+1)*A+(S-1),_=(s+1)*A+S,T=(s+1)*(A-1)+S;p.push(C,E,T),p.push(E,_,T)}}function v(){for(let A=0;A<=e;A++)for(let S=0;S<=s;S++)c.x=A/e,c.y=S/s,f.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new i(new wM[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}};function Br(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(yy(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(yy(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Bn(i){let t={};for(let e=0;e<i.length;e++){let n=Br(i[e]);for(let s in n)t[s]=n[s]}return t}function yy(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function TM(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Tp(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var h_={clone:Br,merge:Bn},EM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,AM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,is=class extends As{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=EM,this.fragmentShader=AM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Br(t.uniforms),this.uniformsGroups=TM(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ot().fromArray(s.value);break;case"v3":this.uniforms[n].value=new z().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ye().fromArray(s.value);break;case"m3":this.uniforms[n].value=new te().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Oe().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Rh=class extends is{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Wo=class extends As{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Cu,this.normalScale=new Ot(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Es,this.combine=Gh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Ch=class extends As{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Yy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Ph=class extends As{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Io(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Qc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ir=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ih=class extends ir{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hf,endingEnd:Hf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Vf:r=t,a=2*e-n;break;case Gf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Vf:o=t,l=2*n-e;break;case Gf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,v=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,A=(-1-f)*m+(1.5+f)*x+.5*p,S=f*m-f*x;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+v*o[c+C]+A*o[l+C]+S*o[u+C];return r}},Lh=class extends ir{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Dh=class extends ir{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Nh=class extends ir{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,v=u[g],A=u[g+1],S=t*d+p*2,C=h[S],E=h[S+1],_=CM(n,e,v,C,s);r[p]=u_(_,x,A,E,m)}return r}};function u_(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function RM(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function CM(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=u_(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=RM(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Io(e,this.TimeBufferType),this.values=Io(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Io(t.times,Array),values:Io(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Qc(t.settings)&&(n.settings={inTangents:Io(t.settings.inTangents,Array),outTangents:Io(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Lh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ih(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Nh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ha:e=this.InterpolantFactoryMethodDiscrete;break;case fh:e=this.InterpolantFactoryMethodLinear;break;case nh:e=this.InterpolantFactoryMethodSmooth;break;case zf:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $t("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ha;case this.InterpolantFactoryMethodLinear:return fh;case this.InterpolantFactoryMethodSmooth:return nh;case this.InterpolantFactoryMethodBezier:return zf}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Qc(this.settings)&&(_y(this.settings.inTangents,t),_y(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Qc(this.settings)&&(xy(this.settings.inTangents,t),xy(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Qt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Qt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Qt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Qt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&OS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===nh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Qc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function _y(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function xy(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=fh;var sr=class extends fi{constructor(t,e,n){super(t,e,n)}};sr.prototype.ValueTypeName="bool";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=Ha;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var Fh=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}};Fh.prototype.ValueTypeName="color";var Uh=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}};Uh.prototype.ValueTypeName="number";var Oh=class extends ir{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},rl=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Oh(this.times,this.values,this.getValueSize(),t)}};rl.prototype.ValueTypeName="quaternion";rl.prototype.InterpolantFactoryMethodSmooth=void 0;var rr=class extends fi{constructor(t,e,n){super(t,e,n)}};rr.prototype.ValueTypeName="string";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=Ha;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var kh=class extends fi{constructor(t,e,n,s){super(t,e,n,s)}};kh.prototype.ValueTypeName="vector";var Bh=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},d_=new Bh,zh=class{constructor(t){this.manager=t!==void 0?t:d_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};zh.DEFAULT_MATERIAL_NAME="__DEFAULT";var ol=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},al=class extends ol{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Bf=new Oe,vy=new z,by=new z,Hh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ot(512,512),this.mapType=jn,this.map=null,this.mapPass=null,this.matrix=new Oe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new er,this._frameExtents=new Ot(1,1),this._viewportCount=1,this._viewports=[new Ye(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;vy.setFromMatrixPosition(t.matrixWorld),e.position.copy(vy),by.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(by),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Bf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Bf,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Oo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Bf)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},th=new z,eh=new ui,Qi=new z,ll=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Oe,this.projectionMatrix=new Oe,this.projectionMatrixInverse=new Oe,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(th,eh,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(th,eh,Qi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(th,eh,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(th,eh,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Qs=new z,Sy=new Ot,My=new Ot,$n=class extends ll{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Bo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(No*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Bo*2*Math.atan(Math.tan(No*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Qs.x,Qs.y).multiplyScalar(-t/Qs.z),Qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Qs.x,Qs.y).multiplyScalar(-t/Qs.z)}getViewSize(t,e){return this.getViewBounds(t,Sy,My),e.subVectors(My,Sy)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(No*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var cl=class extends ll{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Wf=class extends Hh{constructor(){super(new cl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},hl=class extends ol{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Wf}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Lo=-90,Do=1,Xo=class extends Nn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(Lo,Do,t,e);s.layers=this.layers,this.add(s);let r=new $n(Lo,Do,t,e);r.layers=this.layers,this.add(r);let o=new $n(Lo,Do,t,e);o.layers=this.layers,this.add(o);let a=new $n(Lo,Do,t,e);a.layers=this.layers,this.add(a);let l=new $n(Lo,Do,t,e);l.layers=this.layers,this.add(l);let c=new $n(Lo,Do,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===vi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Oo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Vh=class extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Ep="\\[\\]\\.:\\/",PM=new RegExp("["+Ep+"]","g"),Ap="[^"+Ep+"]",IM="[^"+Ep.replace("\\.","")+"]",LM=/((?:WC+[\/:])*)/.source.replace("WC",Ap),DM=/(WCOD+)?/.source.replace("WCOD",IM),NM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ap),FM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ap),UM=new RegExp("^"+LM+DM+NM+FM+"$"),OM=["material","materials","bones","map"],Xf=class{constructor(t,e,n){let s=n||We.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},We=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(PM,"")}static parseTrackName(t){let e=UM.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);OM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Qt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Qt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Qt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Qt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){Qt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Qt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};We.Composite=Xf;We.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};We.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};We.prototype.GetterByBindingType=[We.prototype._getValue_direct,We.prototype._getValue_array,We.prototype._getValue_arrayElement,We.prototype._getValue_toArray];We.prototype.SetterByBindingTypeAndVersioning=[[We.prototype._setValue_direct,We.prototype._setValue_direct_setNeedsUpdate,We.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[We.prototype._setValue_array,We.prototype._setValue_array_setNeedsUpdate,We.prototype._setValue_array_setMatrixWorldNeedsUpdate],[We.prototype._setValue_arrayElement,We.prototype._setValue_arrayElement_setNeedsUpdate,We.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[We.prototype._setValue_fromArray,We.prototype._setValue_fromArray_setNeedsUpdate,We.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var VL=new Float32Array(1);var qo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var qf=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var ul=class extends Fi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Rp(i,t,e,n){let s=kM(n);switch(e){case up:return i*t;case fp:return i*t/s.components*s.byteLength;case Jh:return i*t/s.components*s.byteLength;case cr:return i*t*2/s.components*s.byteLength;case Kh:return i*t*2/s.components*s.byteLength;case dp:return i*t*3/s.components*s.byteLength;case Bi:return i*t*4/s.components*s.byteLength;case jh:return i*t*4/s.components*s.byteLength;case pl:case ml:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case gl:case yl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case tu:case nu:return Math.max(i,16)*Math.max(t,8)/4;case Qh:case eu:return Math.max(i,8)*Math.max(t,8)/2;case iu:case su:case ou:case au:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case ru:case _l:case lu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case cu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case hu:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case uu:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case du:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case fu:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case pu:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case mu:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case gu:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case yu:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case _u:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case xu:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case vu:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case bu:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Su:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Mu:case wu:case Tu:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Eu:case Au:return Math.ceil(i/4)*Math.ceil(t/4)*8;case xl:case Ru:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function kM(i){switch(i){case jn:case ap:return{byteLength:1,components:1};case Jo:case lp:case ki:return{byteLength:2,components:1};case Yh:case Zh:return{byteLength:2,components:4};case Ui:case $h:case Oi:return{byteLength:4,components:1};case cp:case hp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function N_(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function zM(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var HM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,VM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,GM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,WM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,XM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,qM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,$M=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,YM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ZM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,JM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,KM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,jM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,QM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,tw=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,ew=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,nw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,iw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,sw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,rw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,ow=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,aw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,lw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,cw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,hw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,uw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,dw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,fw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,pw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,mw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,gw="gl_FragColor = linearToOutputTexel( gl_FragColor );",yw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,_w=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,xw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,vw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,bw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Sw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Mw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ww=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Tw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Ew=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Aw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Rw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Cw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Pw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Iw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Lw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Dw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Nw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Fw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Uw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ow=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,kw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Bw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,zw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Hw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Vw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Gw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ww=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Xw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,$w=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Yw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Zw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Jw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Kw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,jw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Qw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,tT=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,eT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,nT=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,iT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,sT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,rT=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,oT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,aT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,lT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,cT=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,hT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,uT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,dT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,fT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,pT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,mT=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,gT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,yT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,_T=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,xT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,vT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,bT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,ST=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,MT=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,wT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,TT=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ET=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,AT=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,RT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,CT=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,PT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,IT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,LT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,DT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,NT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,FT=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,UT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,OT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,kT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,BT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,zT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,HT=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,GT=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,XT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,$T=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,YT=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ZT=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,JT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,KT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jT=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,t1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,e1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,n1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,i1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,s1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,r1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,o1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,a1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,l1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,c1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,h1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,u1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,d1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,f1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,p1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,m1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,g1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,y1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,_1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,x1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ue={alphahash_fragment:HM,alphahash_pars_fragment:VM,alphamap_fragment:GM,alphamap_pars_fragment:WM,alphatest_fragment:XM,alphatest_pars_fragment:qM,aomap_fragment:$M,aomap_pars_fragment:YM,batching_pars_vertex:ZM,batching_vertex:JM,begin_vertex:KM,beginnormal_vertex:jM,bsdfs:QM,iridescence_fragment:tw,bumpmap_pars_fragment:ew,clipping_planes_fragment:nw,clipping_planes_pars_fragment:iw,clipping_planes_pars_vertex:sw,clipping_planes_vertex:rw,color_fragment:ow,color_pars_fragment:aw,color_pars_vertex:lw,color_vertex:cw,common:hw,defaultnormal_vertex:uw,displacementmap_pars_vertex:dw,displacementmap_vertex:fw,emissivemap_fragment:pw,emissivemap_pars_fragment:mw,colorspace_fragment:gw,colorspace_pars_fragment:yw,envmap_fragment:_w,envmap_common_pars_fragment:xw,envmap_pars_fragment:vw,envmap_pars_vertex:bw,envmap_physical_pars_fragment:Lw,envmap_vertex:Sw,fog_vertex:Mw,fog_pars_vertex:ww,fog_fragment:Tw,fog_pars_fragment:Ew,gradientmap_pars_fragment:Aw,lightmap_pars_fragment:Rw,lights_lambert_fragment:Cw,lights_lambert_pars_fragment:Pw,lights_pars_begin:Iw,lights_toon_fragment:Dw,lights_toon_pars_fragment:Nw,lights_phong_fragment:Fw,lights_phong_pars_fragment:Uw,lights_physical_fragment:Ow,lights_physical_pars_fragment:kw,lights_fragment_begin:Bw,lights_fragment_maps:zw,lights_fragment_end:Hw,lightprobes_pars_fragment:Vw,logdepthbuf_fragment:Gw,logdepthbuf_pars_fragment:Ww,logdepthbuf_pars_vertex:Xw,logdepthbuf_vertex:qw,map_fragment:$w,map_pars_fragment:Yw,map_particle_fragment:Zw,map_particle_pars_fragment:Jw,metalnessmap_fragment:Kw,metalnessmap_pars_fragment:jw,morphinstance_vertex:Qw,morphcolor_vertex:tT,morphnormal_vertex:eT,morphtarget_pars_vertex:nT,morphtarget_vertex:iT,normal_fragment_begin:sT,normal_fragment_maps:rT,normal_pars_fragment:oT,normal_pars_vertex:aT,normal_vertex:lT,normalmap_pars_fragment:cT,clearcoat_normal_fragment_begin:hT,clearcoat_normal_fragment_maps:uT,clearcoat_pars_fragment:dT,iridescence_pars_fragment:fT,opaque_fragment:pT,packing:mT,premultiplied_alpha_fragment:gT,project_vertex:yT,dithering_fragment:_T,dithering_pars_fragment:xT,roughnessmap_fragment:vT,roughnessmap_pars_fragment:bT,shadowmap_pars_fragment:ST,shadowmap_pars_vertex:MT,shadowmap_vertex:wT,shadowmask_pars_fragment:TT,skinbase_vertex:ET,skinning_pars_vertex:AT,skinning_vertex:RT,skinnormal_vertex:CT,specularmap_fragment:PT,specularmap_pars_fragment:IT,tonemapping_fragment:LT,tonemapping_pars_fragment:DT,transmission_fragment:NT,transmission_pars_fragment:FT,uv_pars_fragment:UT,uv_pars_vertex:OT,uv_vertex:kT,worldpos_vertex:BT,background_vert:zT,background_frag:HT,backgroundCube_vert:VT,backgroundCube_frag:GT,cube_vert:WT,cube_frag:XT,depth_vert:qT,depth_frag:$T,distance_vert:YT,distance_frag:ZT,equirect_vert:JT,equirect_frag:KT,linedashed_vert:jT,linedashed_frag:QT,meshbasic_vert:t1,meshbasic_frag:e1,meshlambert_vert:n1,meshlambert_frag:i1,meshmatcap_vert:s1,meshmatcap_frag:r1,meshnormal_vert:o1,meshnormal_frag:a1,meshphong_vert:l1,meshphong_frag:c1,meshphysical_vert:h1,meshphysical_frag:u1,meshtoon_vert:d1,meshtoon_frag:f1,points_vert:p1,points_frag:m1,shadow_vert:g1,shadow_frag:y1,sprite_vert:_1,sprite_frag:x1},Lt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new te}},envmap:{envMap:{value:null},envMapRotation:{value:new te},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new te}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new te}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new te},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new te},normalScale:{value:new Ot(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new te},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new te}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new te}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new te}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0},uvTransform:{value:new te}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Ot(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}}},as={basic:{uniforms:Bn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:Bn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:Bn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:Bn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:Bn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new he(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:Bn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:Bn([Lt.points,Lt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:Bn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:Bn([Lt.common,Lt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:Bn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:Bn([Lt.sprite,Lt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new te},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new te}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:Bn([Lt.common,Lt.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:Bn([Lt.lights,Lt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};as.physical={uniforms:Bn([as.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new te},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new te},clearcoatNormalScale:{value:new Ot(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new te},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new te},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new te},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new te},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new te},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new te},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new te},transmissionSamplerSize:{value:new Ot},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new te},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new te},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new te},anisotropyVector:{value:new Ot},anisotropyMap:{value:null},anisotropyMapTransform:{value:new te}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var Pu={r:0,b:0,g:0},v1=new Oe,F_=new te;F_.set(-1,0,0,0,1,0,0,0,1);function b1(i,t,e,n,s,r){let o=new he(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let S=v.backgroundBlurriness>0;A=t.get(A,S)}return A}function p(v){let A=!1,S=f(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,A){let S=f(A);S&&S.isCubeTexture?(c===void 0&&(c=new Xe(new ns(1,1,1),new is({name:"BackgroundCubeMaterial",uniforms:Br(as.backgroundCube.uniforms),vertexShader:as.backgroundCube.vertexShader,fragmentShader:as.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(v1.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(F_),c.material.toneMapped=_e.getTransfer(S.colorSpace)!==Ee,(h!==S||u!==S.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Xe(new nl(2,2),new is({name:"BackgroundMaterial",uniforms:Br(as.background.uniforms),vertexShader:as.background.vertexShader,fragmentShader:as.background.fragmentShader,side:lr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=_e.getTransfer(S.colorSpace)!==Ee,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,A){v.getRGB(Pu,Tp(i)),e.buffers.color.setClear(Pu.r,Pu.g,Pu.b,A,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:x,dispose:g}}function S1(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,H,W,L,X){let Y=!1,G=u(D,L,W,H);r!==G&&(r=G,c(r.object)),Y=f(D,L,W,X),Y&&p(D,L,W,X),X!==null&&t.update(X,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(D,H,W,L),X!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(X).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,H,W,L){let X=L.wireframe===!0,Y=n[H.id];Y===void 0&&(Y={},n[H.id]=Y);let G=D.isInstancedMesh===!0?D.id:0,ct=Y[G];ct===void 0&&(ct={},Y[G]=ct);let K=ct[W.id];K===void 0&&(K={},ct[W.id]=K);let Q=K[X];return Q===void 0&&(Q=d(l()),K[X]=Q),Q}function d(D){let H=[],W=[],L=[];for(let X=0;X<e;X++)H[X]=0,W[X]=0,L[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:W,attributeDivisors:L,object:D,attributes:{},index:null}}function f(D,H,W,L){let X=r.attributes,Y=H.attributes,G=0,ct=W.getAttributes();for(let K in ct)if(ct[K].location>=0){let st=X[K],dt=Y[K];if(dt===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(dt=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(dt=D.instanceColor)),st===void 0||st.attribute!==dt||dt&&st.data!==dt.data)return!0;G++}return r.attributesNum!==G||r.index!==L}function p(D,H,W,L){let X={},Y=H.attributes,G=0,ct=W.getAttributes();for(let K in ct)if(ct[K].location>=0){let st=Y[K];st===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(st=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(st=D.instanceColor));let dt={};dt.attribute=st,st&&st.data&&(dt.data=st.data),X[K]=dt,G++}r.attributes=X,r.attributesNum=G,r.index=L}function x(){let D=r.newAttributes;for(let H=0,W=D.length;H<W;H++)D[H]=0}function m(D){g(D,0)}function g(D,H){let W=r.newAttributes,L=r.enabledAttributes,X=r.attributeDivisors;W[D]=1,L[D]===0&&(i.enableVertexAttribArray(D),L[D]=1),X[D]!==H&&(i.vertexAttribDivisor(D,H),X[D]=H)}function v(){let D=r.newAttributes,H=r.enabledAttributes;for(let W=0,L=H.length;W<L;W++)H[W]!==D[W]&&(i.disableVertexAttribArray(W),H[W]=0)}function A(D,H,W,L,X,Y,G){G===!0?i.vertexAttribIPointer(D,H,W,X,Y):i.vertexAttribPointer(D,H,W,L,X,Y)}function S(D,H,W,L){x();let X=L.attributes,Y=W.getAttributes(),G=H.defaultAttributeValues;for(let ct in Y){let K=Y[ct];if(K.location>=0){let Q=X[ct];if(Q===void 0&&(ct==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ct==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let st=Q.normalized,dt=Q.itemSize,ut=t.get(Q);if(ut===void 0)continue;let tt=ut.buffer,mt=ut.type,_t=ut.bytesPerElement,At=mt===i.INT||mt===i.UNSIGNED_INT||Q.gpuType===$h;if(Q.isInterleavedBufferAttribute){let St=Q.data,Wt=St.isInterleavedBuffer===!0?St.stride:St.itemSize,ie=Q.offset;if(St.isInstancedInterleavedBuffer||St.isInstancedBufferAttribute){for(let Vt=0;Vt<K.locationSize;Vt++)g(K.location+Vt,St.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=St.meshPerAttribute*St.count)}else for(let Vt=0;Vt<K.locationSize;Vt++)m(K.location+Vt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Vt=0;Vt<K.locationSize;Vt++)A(K.location+Vt,dt/K.locationSize,mt,st,Wt*_t,(ie+dt/K.locationSize*Vt)*_t,At)}else{if(Q.isInstancedBufferAttribute){for(let St=0;St<K.locationSize;St++)g(K.location+St,Q.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let St=0;St<K.locationSize;St++)m(K.location+St);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let St=0;St<K.locationSize;St++)A(K.location+St,dt/K.locationSize,mt,st,dt*_t,dt/K.locationSize*St*_t,At)}}else if(G!==void 0){let st=G[ct];if(st!==void 0)switch(st.length){case 2:i.vertexAttrib2fv(K.location,st);break;case 3:i.vertexAttrib3fv(K.location,st);break;case 4:i.vertexAttrib4fv(K.location,st);break;default:i.vertexAttrib1fv(K.location,st)}}}}v()}function C(){k();for(let D in n){let H=n[D];for(let W in H){let L=H[W];for(let X in L){let Y=L[X];for(let G in Y)h(Y[G].object),delete Y[G];delete L[X]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let H=n[D.id];for(let W in H){let L=H[W];for(let X in L){let Y=L[X];for(let G in Y)h(Y[G].object),delete Y[G];delete L[X]}}delete n[D.id]}function _(D){for(let H in n){let W=n[H];for(let L in W){let X=W[L];if(X[D.id]===void 0)continue;let Y=X[D.id];for(let G in Y)h(Y[G].object),delete Y[G];delete X[D.id]}}}function T(D){for(let H in n){let W=n[H],L=D.isInstancedMesh===!0?D.id:0,X=W[L];if(X!==void 0){for(let Y in X){let G=X[Y];for(let ct in G)h(G[ct].object),delete G[ct];delete X[Y]}delete W[L],Object.keys(W).length===0&&delete n[H]}}}function k(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:F,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:v}}function M1(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function w1(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Bi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===ki&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==jn&&_!==Oi&&!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&($t("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:S,maxSamples:C,samples:E}}function T1(i){let t=this,e=null,n=0,s=!1,r=!1,o=new hi,a=new te,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let v=r?0:n,A=v*4,S=g.clippingState||null;l.value=S,S=h(p,d,A,f);for(let C=0;C!==A;++C)S[C]=e[C];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let A=0,S=f;A!==x;++A,S+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Sl=class extends di{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Ka(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ns(5,5,5),r=new is({name:"CubemapFromEquirect",uniforms:Br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Zn,blending:Fr});r.uniforms.tEquirect.value=e;let o=new Xe(s,r),a=e.minFilter;return e.minFilter===Is&&(e.minFilter=Yn),new Xo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},f_=256,E1=3,A1=20,U_=256,O_=16,R1=3,C1=new z,P1=new he,Lu=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xo(1,10,null),this._boxMesh=new Xe(new ns(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=C1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(P1));let m=new Xo(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=g_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=m_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(f_,bp(t))}_fromTexture(t,e){t.mapping===Or||t.mapping===Zo?this._setSize(t.image.length===0?f_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=p_(t,!1,!1),n=Math.log2(t)-E1;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=p_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Or||t.mapping===Zo?(this._cubemapMaterial===null&&(this._cubemapMaterial=g_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=m_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=I1(),this._integrationMaterial=L1());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/O_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-R1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(U_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=D1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function p_(i,t,e){return new Sl(i,{minFilter:Is,generateMipmaps:t,type:ki,colorSpace:Va,depthBuffer:e})}function Ml(i,t,e){return new is({name:i,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:Zn,blending:Fr,depthTest:!1,depthWrite:!1})}function I1(){return Ml("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${U_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function L1(){return Ml("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:O_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function D1(){return Ml("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${A1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function m_(){return Ml("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function g_(){return Ml("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function N1(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Wh||f===Xh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Sl(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Wh||f===Xh,x=f===Or||f===Zo;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Lu(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return p&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new Lu(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Wh?d.mapping=Or:f===Xh&&(d.mapping=Zo),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function F1(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Oa("WebGLRenderer: "+n+" extension not supported."),s}}}function U1(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=x!==null?x.array.length:m.array.length/3-1,A=m.count>=65535?Za:Ya,S=new A(Math.ceil(v/3)*6,1),C=S.array;if(x!==null){let _=x.array;g=x.version;for(let T=0,k=0;T<v;T+=3){let F=_[T+0],D=_[T+1],H=_[T+2];C[k++]=F,C[k++]=D,C[k++]=D,C[k++]=H,C[k++]=H,C[k++]=F}}else{g=m.version;for(let _=0,T=0;_<v;_+=3){let k=_+0,F=_+1,D=_+2;C[T++]=k,C[T++]=F,C[T++]=F,C[T++]=D,C[T++]=D,C[T++]=k}}S.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,S)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function O1(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function k1(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Qt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function B1(i,t,e){let n=new WeakMap,s=new Ye;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let k=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),x===!0&&(A=3);let S=a.attributes.position.count*A,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let E=new Float32Array(S*C*4*u),_=new Xa(E,S,C,u);_.type=Oi,_.needsUpdate=!0;let T=A*4;for(let F=0;F<u;F++){let D=m[F],H=g[F],W=v[F],L=S*C*4*F;for(let X=0;X<D.count;X++){let Y=X*T;f===!0&&(s.fromBufferAttribute(D,X),E[L+Y+0]=s.x,E[L+Y+1]=s.y,E[L+Y+2]=s.z,E[L+Y+3]=0),p===!0&&(s.fromBufferAttribute(H,X),E[L+Y+4]=s.x,E[L+Y+5]=s.y,E[L+Y+6]=s.z,E[L+Y+7]=0),x===!0&&(s.fromBufferAttribute(W,X),E[L+Y+8]=s.x,E[L+Y+9]=s.y,E[L+Y+10]=s.z,E[L+Y+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new Ot(S,C)},n.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function z1(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var H1={[Qf]:"LINEAR_TONE_MAPPING",[tp]:"REINHARD_TONE_MAPPING",[ep]:"CINEON_TONE_MAPPING",[np]:"ACES_FILMIC_TONE_MAPPING",[sp]:"AGX_TONE_MAPPING",[rp]:"NEUTRAL_TONE_MAPPING",[ip]:"CUSTOM_TONE_MAPPING"};function V1(i,t,e,n,s,r){let o=new di(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new je;h.setAttribute("position",new ke([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ke([0,2,0,0,2,0],2));let u=new Rh({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Xe(h,u),f=new cl(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,v=null,A=[],S=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let _=0;_<A.length;_++){let T=A[_];T.setSize&&T.setSize(C,E)}},this.setEffects=function(C){A=C,S=A.length>0&&A[0].isRenderPass===!0;let E=o.width,_=o.height;A.length>0&&a===null&&(a=new di(E,_,{type:ki,depthBuffer:!1,stencilBuffer:!1}),l=new di(E,_,{type:ki,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ps(E,_),r===!0&&(c.format=Ls,c.type=kr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<A.length;k++){let F=A[k];F.setSize&&F.setSize(E,_),T&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===rs&&A.length===0)return!1;if(v=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return S===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=rs,!0},this.hasRenderPass=function(){return S},this.end=function(C,E){C.toneMapping=g,m=!0;let _=o,T=a;for(let k=0;k<A.length;k++){let F=A[k];F.enabled!==!1&&(F.render(C,T,_,E),F.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(p!==C.outputColorSpace||x!==C.toneMapping){p=C.outputColorSpace,x=C.toneMapping,u.defines={},_e.getTransfer(p)===Ee&&(u.defines.SRGB_TRANSFER="");let k=H1[x];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var k_=new Kn,B_=new Ps(1,1),z_=new ja(1),H_=new Xa,V_=new gh,G_=new Ka,y_=[],__=[],x_=new Float32Array(16),v_=new Float32Array(9),b_=new Float32Array(4);function Qo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=y_[s];if(r===void 0&&(r=new Float32Array(s),y_[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function vn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function bn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Nu(i,t){let e=__[t];e===void 0&&(e=new Int32Array(t),__[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function G1(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function W1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2fv(this.addr,t),bn(e,t)}}function X1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vn(e,t))return;i.uniform3fv(this.addr,t),bn(e,t)}}function q1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4fv(this.addr,t),bn(e,t)}}function $1(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(vn(e,n))return;b_.set(n),i.uniformMatrix2fv(this.addr,!1,b_),bn(e,n)}}function Y1(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(vn(e,n))return;v_.set(n),i.uniformMatrix3fv(this.addr,!1,v_),bn(e,n)}}function Z1(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(vn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(vn(e,n))return;x_.set(n),i.uniformMatrix4fv(this.addr,!1,x_),bn(e,n)}}function J1(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function K1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2iv(this.addr,t),bn(e,t)}}function j1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;i.uniform3iv(this.addr,t),bn(e,t)}}function Q1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4iv(this.addr,t),bn(e,t)}}function tE(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function eE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;i.uniform2uiv(this.addr,t),bn(e,t)}}function nE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;i.uniform3uiv(this.addr,t),bn(e,t)}}function iE(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;i.uniform4uiv(this.addr,t),bn(e,t)}}function Fu(i){return i.version===0&&(i.compareFunction=gp,i.needsUpdate=!0),i}function sE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Fu(B_):r=k_,e.setTexture2D(t||r,s)}function rE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||V_,s)}function oE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Fu(z_):r=G_,e.setTextureCube(t||r,s)}function aE(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||H_,s)}function lE(i){switch(i){case 5126:return G1;case 35664:return W1;case 35665:return X1;case 35666:return q1;case 35674:return $1;case 35675:return Y1;case 35676:return Z1;case 5124:case 35670:return J1;case 35667:case 35671:return K1;case 35668:case 35672:return j1;case 35669:case 35673:return Q1;case 5125:return tE;case 36294:return eE;case 36295:return nE;case 36296:return iE;case 35678:case 36198:case 36298:case 36306:case 35682:return sE;case 35679:case 36299:case 36307:return rE;case 35680:case 36300:case 36308:case 36293:return oE;case 36289:case 36303:case 36311:case 36292:return aE}}function cE(i,t){i.uniform1fv(this.addr,t)}function hE(i,t){let e=Qo(t,this.size,2);i.uniform2fv(this.addr,e)}function uE(i,t){let e=Qo(t,this.size,3);i.uniform3fv(this.addr,e)}function dE(i,t){let e=Qo(t,this.size,4);i.uniform4fv(this.addr,e)}function fE(i,t){let e=Qo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function pE(i,t){let e=Qo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function mE(i,t){let e=Qo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function gE(i,t){i.uniform1iv(this.addr,t)}function yE(i,t){i.uniform2iv(this.addr,t)}function _E(i,t){i.uniform3iv(this.addr,t)}function xE(i,t){i.uniform4iv(this.addr,t)}function vE(i,t){i.uniform1uiv(this.addr,t)}function bE(i,t){i.uniform2uiv(this.addr,t)}function SE(i,t){i.uniform3uiv(this.addr,t)}function ME(i,t){i.uniform4uiv(this.addr,t)}function wE(i,t,e){let n=this.cache,s=t.length,r=Nu(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Fu(B_):o=k_;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function TE(i,t,e){let n=this.cache,s=t.length,r=Nu(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||V_,r[o])}function EE(i,t,e){let n=this.cache,s=t.length,r=Nu(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Fu(z_):o=G_;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function AE(i,t,e){let n=this.cache,s=t.length,r=Nu(e,s);vn(n,r)||(i.uniform1iv(this.addr,r),bn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||H_,r[o])}function RE(i){switch(i){case 5126:return cE;case 35664:return hE;case 35665:return uE;case 35666:return dE;case 35674:return fE;case 35675:return pE;case 35676:return mE;case 5124:case 35670:return gE;case 35667:case 35671:return yE;case 35668:case 35672:return _E;case 35669:case 35673:return xE;case 5125:return vE;case 36294:return bE;case 36295:return SE;case 36296:return ME;case 35678:case 36198:case 36298:case 36306:case 35682:return wE;case 35679:case 36299:case 36307:return TE;case 35680:case 36300:case 36308:case 36293:return EE;case 36289:case 36303:case 36311:case 36292:return AE}}var Ip=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=lE(e.type)}},Lp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=RE(e.type)}},Dp=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Cp=/(\w+)(\])?(\[|\.)?/g;function S_(i,t){i.seq.push(t),i.map[t.id]=t}function CE(i,t,e){let n=i.name,s=n.length;for(Cp.lastIndex=0;;){let r=Cp.exec(n),o=Cp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){S_(e,c===void 0?new Ip(a,i,t):new Lp(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Dp(a),S_(e,u)),e=u}}}var jo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);CE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function M_(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var PE=37297,IE=0;function LE(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var w_=new te;function DE(i){_e._getMatrix(w_,_e.workingColorSpace,i);let t=`mat3( ${w_.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(i)){case Ga:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function T_(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+LE(i.getShaderSource(t),a)}else return r}function NE(i,t){let e=DE(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var FE={[Qf]:"Linear",[tp]:"Reinhard",[ep]:"Cineon",[np]:"ACESFilmic",[sp]:"AgX",[rp]:"Neutral",[ip]:"Custom"};function UE(i,t){let e=FE[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Iu=new z;function OE(){_e.getLuminanceCoefficients(Iu);let i=Iu.x.toFixed(4),t=Iu.y.toFixed(4),e=Iu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function kE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(bl).join(`
`)}function BE(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function zE(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function bl(i){return i!==""}function E_(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function A_(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var HE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Np(i){return i.replace(HE,VE)}function VE(i,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Np(e)}var GE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function R_(i){return i.replace(GE,WE)}function WE(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function C_(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var XE={[dl]:"SHADOWMAP_TYPE_PCF",[$o]:"SHADOWMAP_TYPE_VSM"};function qE(i){return XE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var $E={[Zo]:"ENVMAP_MODE_REFRACTION"};function YE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":$E[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ZE={[Gh]:"ENVMAP_BLENDING_MULTIPLY",[Xy]:"ENVMAP_BLENDING_MIX",[qy]:"ENVMAP_BLENDING_ADD"};function JE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":ZE[i.combine]||"ENVMAP_BLENDING_NONE"}function KE(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=qE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=YE(e),u=JE(e),d=kE(e),f=BE(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(bl).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(bl).join(`
`),m.length>0&&(m+=`
`)):(x=[C_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(bl).join(`
`),m=[C_(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==rs?"#define TONE_MAPPING":"",e.toneMapping!==rs?ue.tonemapping_pars_fragment:"",e.toneMapping!==rs?UE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,NE("linearToOutputTexel",e.outputColorSpace),OE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(bl).join(`
`)),o=Np(o),o=E_(o,e),o=A_(o,e),a=Np(a),a=E_(a,e),a=A_(a,e),o=R_(o),a=R_(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===_p?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===_p?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+x+o,A=g+m+a,S=M_(s,s.VERTEX_SHADER,v),C=M_(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(F){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(S)||"",W=s.getShaderInfoLog(C)||"",L=D.trim(),X=H.trim(),Y=W.trim(),G=!0,ct=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,S,C);else{let K=T_(s,S,"vertex"),Q=T_(s,C,"fragment");Qt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+L+`
`+K+`
`+Q)}else L!==""?$t("WebGLProgram: Program Info Log:",L):(X===""||Y==="")&&(ct=!1);ct&&(F.diagnostics={runnable:G,programLog:L,vertexShader:{log:X,prefix:x},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(S),s.deleteShader(C),_=new jo(s,p),T=zE(s,p)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(p,PE)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=IE++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=C,this}var jE=0,Fp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Up(t),e.set(t,n)),n}},Up=class{constructor(t){this.id=jE++,this.code=t,this.usedTimes=0}};function QE(i){return i===cr||i===_l||i===xl}function tA(i,t,e,n,s,r){let o=new qa,a=new Fp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,T,k,F,D,H){let W=F.fog,L=D.geometry,X=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?F.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=t.get(_.envMap||X,Y),ct=d[_.type],K=n.precision;_.precision!==null&&(K=n.getMaxPrecision(_.precision),K!==_.precision&&$t("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let Q=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,st=Q!==void 0?Q.length:0,dt=0;L.morphAttributes.position!==void 0&&(dt=1),L.morphAttributes.normal!==void 0&&(dt=2),L.morphAttributes.color!==void 0&&(dt=3);let ut,tt,mt,_t;if(ct){let Rt=as[ct];ut=Rt.vertexShader,tt=Rt.fragmentShader}else{ut=_.vertexShader,tt=_.fragmentShader;let Rt=a.getVertexShaderStage(_),re=a.getFragmentShaderStage(_);a.update(_,Rt,re),mt=Rt.id,_t=re.id}let At=i.getRenderTarget(),St=i.state.buffers.depth.getReversed(),Wt=D.isInstancedMesh===!0,ie=D.isBatchedMesh===!0,Vt=!!_.map,de=!!_.matcap,oe=!!G,ee=oe&&G.isPMREMTexture===!0,qe=!!_.aoMap,Ue=!!_.lightMap,an=!!_.bumpMap&&_.wireframe===!1,Pe=!!_.normalMap,Mn=!!_.displacementMap,xe=!!_.emissiveMap,mn=!!_.metalnessMap,Qe=!!_.roughnessMap,ln=_.anisotropy>0,O=_.clearcoat>0,Ct=_.diffuseRoughness>0,Yt=_.dispersion>0,se=_.retroreflectivity>0,Mt=_.iridescence>0,Le=_.sheen>0,Ht=_.transmission>0,qt=ln&&!!_.anisotropyMap,R=O&&!!_.clearcoatMap,b=O&&!!_.clearcoatNormalMap,q=O&&!!_.clearcoatRoughnessMap,ht=Ct&&!!_.diffuseRoughnessMap,ot=Mt&&!!_.iridescenceMap,yt=Mt&&!!_.iridescenceThicknessMap,xt=Le&&!!_.sheenColorMap,et=Le&&!!_.sheenRoughnessMap,it=!!_.specularMap,pt=!!_.specularColorMap,U=!!_.specularIntensityMap,rt=Ht&&!!_.transmissionMap,nt=Ht&&!!_.thicknessMap,wt=!!_.gradientMap,gt=!!_.alphaMap,bt=_.alphaTest>0,Gt=!!_.alphaHash,Jt=!!_.extensions,lt=rs;_.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(lt=i.toneMapping);let kt=ee?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Kt={shaderID:ct,shaderType:_.type,shaderName:_.name,vertexShader:ut,fragmentShader:tt,defines:_.defines,customVertexShaderID:mt,customFragmentShaderID:_t,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:ie,batchingColor:ie&&D._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&D.instanceColor!==null,instancingMorph:Wt&&D.morphTexture!==null,outputColorSpace:At===null?i.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Vt,matcap:de,envMap:oe,envMapMode:oe&&G.mapping,envMapPMREM:ee,envMapMaxLod:ee?kt.length-1:null,envMapSize:ee?kt[0].width:null,aoMap:qe,lightMap:Ue,bumpMap:an,normalMap:Pe,displacementMap:Mn,emissiveMap:xe,normalMapObjectSpace:Pe&&_.normalMapType===Zy,normalMapTangentSpace:Pe&&_.normalMapType===Cu,packedNormalMap:Pe&&_.normalMapType===Cu&&QE(_.normalMap.format),metalnessMap:mn,roughnessMap:Qe,anisotropy:ln,anisotropyMap:qt,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:b,clearcoatRoughnessMap:q,diffuseRoughness:Ct,diffuseRoughnessMap:ht,dispersion:Yt,retroreflection:se,iridescence:Mt,iridescenceMap:ot,iridescenceThicknessMap:yt,sheen:Le,sheenColorMap:xt,sheenRoughnessMap:et,specularMap:it,specularColorMap:pt,specularIntensityMap:U,transmission:Ht,transmissionMap:rt,thicknessMap:nt,gradientMap:wt,opaque:_.transparent===!1&&_.blending===Yo&&_.alphaToCoverage===!1,alphaMap:gt,alphaTest:bt,alphaHash:Gt,combine:_.combine,mapUv:Vt&&f(_.map.channel),aoMapUv:qe&&f(_.aoMap.channel),lightMapUv:Ue&&f(_.lightMap.channel),bumpMapUv:an&&f(_.bumpMap.channel),normalMapUv:Pe&&f(_.normalMap.channel),displacementMapUv:Mn&&f(_.displacementMap.channel),emissiveMapUv:xe&&f(_.emissiveMap.channel),metalnessMapUv:mn&&f(_.metalnessMap.channel),roughnessMapUv:Qe&&f(_.roughnessMap.channel),anisotropyMapUv:qt&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:xt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(_.sheenRoughnessMap.channel),specularMapUv:it&&f(_.specularMap.channel),specularColorMapUv:pt&&f(_.specularColorMap.channel),specularIntensityMapUv:U&&f(_.specularIntensityMap.channel),transmissionMapUv:rt&&f(_.transmissionMap.channel),thicknessMapUv:nt&&f(_.thicknessMap.channel),alphaMapUv:gt&&f(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Pe||ln),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Vt||gt),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&Pe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:St,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:dt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:H.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:lt,decodeVideoTexture:Vt&&_.map.isVideoTexture===!0&&_e.getTransfer(_.map.colorSpace)===Ee,decodeVideoTextureEmissive:xe&&_.emissiveMap.isVideoTexture===!0&&_e.getTransfer(_.emissiveMap.colorSpace)===Ee,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ss,flipSided:_.side===Zn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Jt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&_.extensions.multiDraw===!0||ie)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function x(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let k in _.defines)T.push(k),T.push(_.defines[k]);return _.isRawShaderMaterial===!1&&(m(T,_),g(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function m(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function g(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let T=d[_.type],k;if(T){let F=as[T];k=h_.clone(F.uniforms)}else k=_.uniforms;return k}function A(_,T){let k=h.get(T);return k!==void 0?++k.usedTimes:(k=new KE(i,T,_,s),c.push(k),h.set(T,k)),k}function S(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:v,acquireProgram:A,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:E}}function eA(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function nA(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function P_(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function I_(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let v=i[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},i[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=p,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=m,v.group=g),t++,v}function l(d,f,p,x,m,g,v){v.reversedDepth===!0&&(m=-m);let A=a(d,f,p,x,m,g);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):e.push(A)}function c(d,f,p,x,m,g){let v=a(d,f,p,x,m,g);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function h(d,f){e.length>1&&e.sort(d||nA),n.length>1&&n.sort(f||P_),s.length>1&&s.sort(f||P_)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function iA(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new I_,i.set(n,[o])):s>=r.length?(o=new I_,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function sA(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new z,color:new he};break;case"SpotLight":e={position:new z,direction:new z,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new z,halfWidth:new z,halfHeight:new z};break}return i[t.id]=e,e}}}function rA(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var oA=0;function aA(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function lA(i){let t=new sA,e=rA(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);let s=new z,r=new Oe,o=new Oe;function a(c){let h=0,u=0,d=0;for(let H=0;H<9;H++)n.probe[H].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,v=0,A=0,S=0,C=0,E=0,_=0,T=0,k=0,F=0;c.sort(aA);for(let H=0,W=c.length;H<W;H++){let L=c[H],X=L.color,Y=L.intensity,G=L.distance,ct=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===cr?ct=L.shadow.map.texture:ct=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=X.r*Y,u+=X.g*Y,d+=X.b*Y;else if(L.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(L.sh.coefficients[K],Y);F++}else if(L.isSunLight){let K=t.get(L);if(K.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Q=L.shadow,st=e.get(L);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=st,n.sunShadowMap[p]=ct;let dt=Q.getViewportCount();for(let ut=0;ut<dt;ut++)n.sunShadowMatrix[x+ut]=Q.getMatrix(ut),n.sunShadowCascade[x+ut]=Q._cascadeData[ut];x+=dt,p++}n.sun[f]=K,f++}else if(L.isDirectionalLight){let K=t.get(L);if(K.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Q=L.shadow,st=e.get(L);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,n.directionalShadow[m]=st,n.directionalShadowMap[m]=ct,n.directionalShadowMatrix[m]=L.shadow.matrix,C++}n.directional[m]=K,m++}else if(L.isSpotLight){let K=t.get(L);K.position.setFromMatrixPosition(L.matrixWorld),K.color.copy(X).multiplyScalar(Y),K.distance=G,K.coneCos=Math.cos(L.angle),K.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),K.decay=L.decay,n.spot[v]=K;let Q=L.shadow;if(L.map&&(n.spotLightMap[T]=L.map,T++,Q.updateMatrices(L),L.castShadow&&k++),n.spotLightMatrix[v]=Q.matrix,L.castShadow){let st=e.get(L);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,n.spotShadow[v]=st,n.spotShadowMap[v]=ct,_++}v++}else if(L.isRectAreaLight){let K=t.get(L);K.color.copy(X).multiplyScalar(Y),K.halfWidth.set(L.width*.5,0,0),K.halfHeight.set(0,L.height*.5,0),n.rectArea[A]=K,A++}else if(L.isPointLight){let K=t.get(L);if(K.color.copy(L.color).multiplyScalar(L.intensity),K.distance=L.distance,K.decay=L.decay,L.castShadow){let Q=L.shadow,st=e.get(L);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,st.shadowCameraNear=Q.camera.near,st.shadowCameraFar=Q.camera.far,n.pointShadow[g]=st,n.pointShadowMap[g]=ct,n.pointShadowMatrix[g]=L.shadow.matrix,E++}n.point[g]=K,g++}else if(L.isHemisphereLight){let K=t.get(L);K.skyColor.copy(L.color).multiplyScalar(Y),K.groundColor.copy(L.groundColor).multiplyScalar(Y),n.hemi[S]=K,S++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Lt.LTC_FLOAT_1,n.rectAreaLTC2=Lt.LTC_FLOAT_2):(n.rectAreaLTC1=Lt.LTC_HALF_1,n.rectAreaLTC2=Lt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==g||D.spotLength!==v||D.rectAreaLength!==A||D.hemiLength!==S||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==_||D.numSpotMaps!==T||D.numLightProbes!==F)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=A,n.point.length=g,n.hemi.length=S,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-k,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=F,D.sunLength=f,D.directionalLength=m,D.pointLength=g,D.spotLength=v,D.rectAreaLength=A,D.hemiLength=S,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=_,D.numSpotMaps=T,D.numLightProbes=F,n.version=oA++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let S=c[v];if(S.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),u++}else if(S.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(S.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let C=n.rectArea[x];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function L_(i){let t=new lA(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function cA(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new L_(i),t.set(s,[a])):r>=o.length?(a=new L_(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var hA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,uA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,dA=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],fA=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],D_=new Oe,vl=new z,Pp=new z;function pA(i,t,e){let n=new er,s=new Ot,r=new Ot,o=new Ye,a=new Ch,l=new Ph,c={},h=e.maxTextureSize,u={[lr]:Zn,[Zn]:lr,[ss]:ss},d=new is({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ot},radius:{value:4}},vertexShader:hA,fragmentShader:uA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new je;p.setAttribute("position",new bi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Xe(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=dl;let g=this.type;this.render=function(E,_,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Ey&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=dl);let k=i.getRenderTarget(),F=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),H=i.state;H.setBlending(Fr),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let W=g!==this.type;W&&_.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(X=>X.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,X=E.length;L<X;L++){let Y=E[L],G=Y.shadow;if(G===void 0){$t("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ct=G.getFrameExtents();s.multiply(ct),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,G.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=K,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===$o){if(Y.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new di(s.x,s.y,{format:cr,type:ki,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new Ps(s.x,s.y,Oi),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=Ts,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Cn,G.map.depthTexture.magFilter=Cn}else Y.isPointLight?(G.map=new Sl(s.x),G.map.depthTexture=new ja(s.x,Ui)):(G.map=new di(s.x,s.y),G.map.depthTexture=new Ps(s.x,s.y,Ui)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=Ts,this.type===dl?(G.map.depthTexture.compareFunction=K?mp:pp,G.map.depthTexture.minFilter=Yn,G.map.depthTexture.magFilter=Yn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Cn,G.map.depthTexture.magFilter=Cn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,T);let st=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let dt=0;dt<Q;dt++){let ut=G.getCamera(dt);if(Y.isPointLight){let tt=G.camera,mt=G.matrix,_t=Y.distance||tt.far;_t!==tt.far&&(tt.far=_t,tt.updateProjectionMatrix()),vl.setFromMatrixPosition(Y.matrixWorld),tt.position.copy(vl),Pp.copy(tt.position),Pp.add(dA[dt]),tt.up.copy(fA[dt]),tt.lookAt(Pp),tt.updateMatrixWorld(),mt.makeTranslation(-vl.x,-vl.y,-vl.z),D_.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),G._frustum.setFromProjectionMatrix(D_,tt.coordinateSystem,tt.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,dt),i.clear();else{dt===0&&(i.setRenderTarget(G.map),i.clear());let tt=G.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),H.viewport(o)}n=G.getFrustum(dt),S(_,T,ut,Y,st,this.type)}G.isPointLightShadow!==!0&&this.type===$o&&v(G,T),G.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(k,F,D)};function v(E,_){let T=t.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new di(s.x,s.y,{format:cr,type:ki}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,T,d,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,T,f,x,null)}function A(E,_,T,k){let F=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)F=D;else if(F=T.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let H=F.uuid,W=_.uuid,L=c[H];L===void 0&&(L={},c[H]=L);let X=L[W];X===void 0&&(X=F.clone(),L[W]=X,_.addEventListener("dispose",C)),F=X}if(F.visible=_.visible,F.wireframe=_.wireframe,k===$o?F.side=_.shadowSide!==null?_.shadowSide:_.side:F.side=_.shadowSide!==null?_.shadowSide:u[_.side],F.alphaMap=_.alphaMap,F.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,F.map=_.map,F.clipShadows=_.clipShadows,F.clippingPlanes=_.clippingPlanes,F.clipIntersection=_.clipIntersection,F.displacementMap=_.displacementMap,F.displacementScale=_.displacementScale,F.displacementBias=_.displacementBias,F.wireframeLinewidth=_.wireframeLinewidth,F.linewidth=_.linewidth,T.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let H=i.properties.get(F);H.light=T}return F}function S(E,_,T,k,F,D){if(E.visible===!1)return;if(E.layers.test(F)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===$o)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let L=t.update(E),X=E.material;if(Array.isArray(X)){let Y=L.groups;for(let G=0,ct=Y.length;G<ct;G++){let K=Y[G],Q=X[K.materialIndex];if(Q&&Q.visible){let st=A(E,Q,k,D);E.onBeforeShadow(i,E,_,T,L,st,K),i.renderBufferDirect(T,null,L,st,E,K),E.onAfterShadow(i,E,_,T,L,st,K)}}}else if(X.visible){let Y=A(E,X,k,D);E.onBeforeShadow(i,E,_,T,L,Y,null),i.renderBufferDirect(T,null,L,Y,E,null),E.onAfterShadow(i,E,_,T,L,Y,null)}}let W=E.children;for(let L=0,X=W.length;L<X;L++)S(W[L],_,T,k,F,D)}function C(E){E.target.removeEventListener("dispose",C);for(let T in c){let k=c[T],F=E.target.uuid;F in k&&(k[F].dispose(),delete k[F])}}}function mA(i,t){function e(){let U=!1,rt=new Ye,nt=null,wt=new Ye(0,0,0,0);return{setMask:function(gt){nt!==gt&&!U&&(i.colorMask(gt,gt,gt,gt),nt=gt)},setLocked:function(gt){U=gt},setClear:function(gt,bt,Gt,Jt,lt){lt===!0&&(gt*=Jt,bt*=Jt,Gt*=Jt),rt.set(gt,bt,Gt,Jt),wt.equals(rt)===!1&&(i.clearColor(gt,bt,Gt,Jt),wt.copy(rt))},reset:function(){U=!1,nt=null,wt.set(-1,0,0,0)}}}function n(){let U=!1,rt=!1,nt=null,wt=null,gt=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Jt=gt;gt=null,this.setClear(Jt)}},getReversed:function(){return rt},setTest:function(bt){bt?St(i.DEPTH_TEST):Wt(i.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!U&&(i.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=o_[bt]),wt!==bt){switch(bt){case sh:i.depthFunc(i.NEVER);break;case rh:i.depthFunc(i.ALWAYS);break;case oh:i.depthFunc(i.LESS);break;case Uo:i.depthFunc(i.LEQUAL);break;case ah:i.depthFunc(i.EQUAL);break;case lh:i.depthFunc(i.GEQUAL);break;case ch:i.depthFunc(i.GREATER);break;case hh:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}wt=bt}},setLocked:function(bt){U=bt},setClear:function(bt){gt!==bt&&(gt=bt,rt&&(bt=1-bt),i.clearDepth(bt))},reset:function(){U=!1,nt=null,wt=null,gt=null,rt=!1}}}function s(){let U=!1,rt=null,nt=null,wt=null,gt=null,bt=null,Gt=null,Jt=null,lt=null;return{setTest:function(kt){U||(kt?St(i.STENCIL_TEST):Wt(i.STENCIL_TEST))},setMask:function(kt){rt!==kt&&!U&&(i.stencilMask(kt),rt=kt)},setFunc:function(kt,Kt,Rt){(nt!==kt||wt!==Kt||gt!==Rt)&&(i.stencilFunc(kt,Kt,Rt),nt=kt,wt=Kt,gt=Rt)},setOp:function(kt,Kt,Rt){(bt!==kt||Gt!==Kt||Jt!==Rt)&&(i.stencilOp(kt,Kt,Rt),bt=kt,Gt=Kt,Jt=Rt)},setLocked:function(kt){U=kt},setClear:function(kt){lt!==kt&&(i.clearStencil(kt),lt=kt)},reset:function(){U=!1,rt=null,nt=null,wt=null,gt=null,bt=null,Gt=null,Jt=null,lt=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,v=null,A=null,S=null,C=null,E=null,_=null,T=new he(0,0,0),k=0,F=!1,D=null,H=null,W=null,L=null,X=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ct=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(K)[1]),G=ct>=1):K.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),G=ct>=2);let Q=null,st={},dt=i.getParameter(i.SCISSOR_BOX),ut=i.getParameter(i.VIEWPORT),tt=new Ye().fromArray(dt),mt=new Ye().fromArray(ut);function _t(U,rt,nt,wt){let gt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(U,bt),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Gt=0;Gt<nt;Gt++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,wt,0,i.RGBA,i.UNSIGNED_BYTE,gt):i.texImage2D(rt+Gt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,gt);return bt}let At={};At[i.TEXTURE_2D]=_t(i.TEXTURE_2D,i.TEXTURE_2D,1),At[i.TEXTURE_CUBE_MAP]=_t(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[i.TEXTURE_2D_ARRAY]=_t(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),At[i.TEXTURE_3D]=_t(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),St(i.DEPTH_TEST),o.setFunc(Uo),an(!1),Pe($f),St(i.CULL_FACE),qe(Fr);function St(U){h[U]!==!0&&(i.enable(U),h[U]=!0)}function Wt(U){h[U]!==!1&&(i.disable(U),h[U]=!1)}function ie(U,rt){return d[U]!==rt?(i.bindFramebuffer(U,rt),d[U]=rt,U===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=rt),U===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(U,rt){let nt=p,wt=!1;if(U){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let gt=U.textures;if(nt.length!==gt.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Gt=gt.length;bt<Gt;bt++)nt[bt]=i.COLOR_ATTACHMENT0+bt;nt.length=gt.length,wt=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,wt=!0);wt&&i.drawBuffers(nt)}function de(U){return x!==U?(i.useProgram(U),x=U,!0):!1}let oe={[Ur]:i.FUNC_ADD,[Ry]:i.FUNC_SUBTRACT,[Cy]:i.FUNC_REVERSE_SUBTRACT};oe[Py]=i.MIN,oe[Iy]=i.MAX;let ee={[Ly]:i.ZERO,[Dy]:i.ONE,[Ny]:i.SRC_COLOR,[Kf]:i.SRC_ALPHA,[zy]:i.SRC_ALPHA_SATURATE,[ky]:i.DST_COLOR,[Uy]:i.DST_ALPHA,[Fy]:i.ONE_MINUS_SRC_COLOR,[jf]:i.ONE_MINUS_SRC_ALPHA,[By]:i.ONE_MINUS_DST_COLOR,[Oy]:i.ONE_MINUS_DST_ALPHA,[Hy]:i.CONSTANT_COLOR,[Vy]:i.ONE_MINUS_CONSTANT_COLOR,[Gy]:i.CONSTANT_ALPHA,[Wy]:i.ONE_MINUS_CONSTANT_ALPHA};function qe(U,rt,nt,wt,gt,bt,Gt,Jt,lt,kt){if(U===Fr){m===!0&&(Wt(i.BLEND),m=!1);return}if(m===!1&&(St(i.BLEND),m=!0),U!==Ay){if(U!==g||kt!==F){if((v!==Ur||C!==Ur)&&(i.blendEquation(i.FUNC_ADD),v=Ur,C=Ur),kt)switch(U){case Yo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Yf:i.blendFunc(i.ONE,i.ONE);break;case Zf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Jf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qt("WebGLState: Invalid blending: ",U);break}else switch(U){case Yo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Yf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Zf:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Jf:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",U);break}A=null,S=null,E=null,_=null,T.set(0,0,0),k=0,g=U,F=kt}return}gt=gt||rt,bt=bt||nt,Gt=Gt||wt,(rt!==v||gt!==C)&&(i.blendEquationSeparate(oe[rt],oe[gt]),v=rt,C=gt),(nt!==A||wt!==S||bt!==E||Gt!==_)&&(i.blendFuncSeparate(ee[nt],ee[wt],ee[bt],ee[Gt]),A=nt,S=wt,E=bt,_=Gt),(Jt.equals(T)===!1||lt!==k)&&(i.blendColor(Jt.r,Jt.g,Jt.b,lt),T.copy(Jt),k=lt),g=U,F=!1}function Ue(U,rt){U.side===ss?Wt(i.CULL_FACE):St(i.CULL_FACE);let nt=U.side===Zn;rt&&(nt=!nt),an(nt),U.blending===Yo&&U.transparent===!1?qe(Fr):qe(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let wt=U.stencilWrite;a.setTest(wt),wt&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),xe(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?St(i.SAMPLE_ALPHA_TO_COVERAGE):Wt(i.SAMPLE_ALPHA_TO_COVERAGE)}function an(U){D!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),D=U)}function Pe(U){U!==wy?(St(i.CULL_FACE),U!==H&&(U===$f?i.cullFace(i.BACK):U===Ty?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Wt(i.CULL_FACE),H=U}function Mn(U){U!==W&&(G&&i.lineWidth(U),W=U)}function xe(U,rt,nt){U?(St(i.POLYGON_OFFSET_FILL),(L!==rt||X!==nt)&&(L=rt,X=nt,o.getReversed()&&(rt=-rt,nt=-nt),i.polygonOffset(rt,nt))):Wt(i.POLYGON_OFFSET_FILL)}function mn(U){U?St(i.SCISSOR_TEST):Wt(i.SCISSOR_TEST)}function Qe(U){U===void 0&&(U=i.TEXTURE0+Y-1),Q!==U&&(i.activeTexture(U),Q=U)}function ln(U,rt,nt){nt===void 0&&(Q===null?nt=i.TEXTURE0+Y-1:nt=Q);let wt=st[nt];wt===void 0&&(wt={type:void 0,texture:void 0},st[nt]=wt),(wt.type!==U||wt.texture!==rt)&&(Q!==nt&&(i.activeTexture(nt),Q=nt),i.bindTexture(U,rt||At[U]),wt.type=U,wt.texture=rt)}function O(){let U=st[Q];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Ct(){try{i.compressedTexImage2D(...arguments)}catch(U){Qt("WebGLState:",U)}}function Yt(){try{i.compressedTexImage3D(...arguments)}catch(U){Qt("WebGLState:",U)}}function se(){try{i.texSubImage2D(...arguments)}catch(U){Qt("WebGLState:",U)}}function Mt(){try{i.texSubImage3D(...arguments)}catch(U){Qt("WebGLState:",U)}}function Le(){try{i.compressedTexSubImage2D(...arguments)}catch(U){Qt("WebGLState:",U)}}function Ht(){try{i.compressedTexSubImage3D(...arguments)}catch(U){Qt("WebGLState:",U)}}function qt(){try{i.texStorage2D(...arguments)}catch(U){Qt("WebGLState:",U)}}function R(){try{i.texStorage3D(...arguments)}catch(U){Qt("WebGLState:",U)}}function b(){try{i.texImage2D(...arguments)}catch(U){Qt("WebGLState:",U)}}function q(){try{i.texImage3D(...arguments)}catch(U){Qt("WebGLState:",U)}}function ht(U){return u[U]!==void 0?u[U]:i.getParameter(U)}function ot(U,rt){u[U]!==rt&&(i.pixelStorei(U,rt),u[U]=rt)}function yt(U){tt.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),tt.copy(U))}function xt(U){mt.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),mt.copy(U))}function et(U,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let wt=nt.get(U);wt===void 0&&(wt=i.getUniformBlockIndex(rt,U.name),i.uniformBlockBinding(rt,wt,wt),nt.set(U,wt))}function it(U,rt,nt){let gt=c.get(rt).get(U);l[gt]!==nt&&(i.bindBufferBase(i.UNIFORM_BUFFER,gt,nt),l[gt]=nt)}function pt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,st={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,v=null,A=null,S=null,C=null,E=null,_=null,T=new he(0,0,0),k=0,F=!1,D=null,H=null,W=null,L=null,X=null,tt.set(0,0,i.canvas.width,i.canvas.height),mt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:St,disable:Wt,bindFramebuffer:ie,drawBuffers:Vt,useProgram:de,setBlending:qe,setMaterial:Ue,setFlipSided:an,setCullFace:Pe,setLineWidth:Mn,setPolygonOffset:xe,setScissorTest:mn,activeTexture:Qe,bindTexture:ln,unbindTexture:O,compressedTexImage2D:Ct,compressedTexImage3D:Yt,texImage2D:b,texImage3D:q,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:it,texStorage2D:qt,texStorage3D:R,texSubImage2D:se,texSubImage3D:Mt,compressedTexSubImage2D:Le,compressedTexSubImage3D:Ht,scissor:yt,viewport:xt,reset:pt}}function gA(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ot,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,b){return m?new OffscreenCanvas(R,b):Wa("canvas")}function v(R,b,q){let ht=1,ot=qt(R);if((ot.width>q||ot.height>q)&&(ht=q/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let yt=Math.floor(ht*ot.width),xt=Math.floor(ht*ot.height);d===void 0&&(d=g(yt,xt));let et=b?g(yt,xt):d;return et.width=yt,et.height=xt,et.getContext("2d").drawImage(R,0,0,yt,xt),$t("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+yt+"x"+xt+")."),et}else return"data"in R&&$t("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(R,b,q,ht,ot,yt=!1){if(R!==null){if(i[R]!==void 0)return i[R];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let xt;ht&&(xt=t.get("EXT_texture_norm16"),xt||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=b;if(b===i.RED&&(q===i.FLOAT&&(et=i.R32F),q===i.HALF_FLOAT&&(et=i.R16F),q===i.UNSIGNED_BYTE&&(et=i.R8),q===i.UNSIGNED_SHORT&&xt&&(et=xt.R16_EXT),q===i.SHORT&&xt&&(et=xt.R16_SNORM_EXT)),b===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.R8UI),q===i.UNSIGNED_SHORT&&(et=i.R16UI),q===i.UNSIGNED_INT&&(et=i.R32UI),q===i.BYTE&&(et=i.R8I),q===i.SHORT&&(et=i.R16I),q===i.INT&&(et=i.R32I)),b===i.RG&&(q===i.FLOAT&&(et=i.RG32F),q===i.HALF_FLOAT&&(et=i.RG16F),q===i.UNSIGNED_BYTE&&(et=i.RG8),q===i.UNSIGNED_SHORT&&xt&&(et=xt.RG16_EXT),q===i.SHORT&&xt&&(et=xt.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.RG8UI),q===i.UNSIGNED_SHORT&&(et=i.RG16UI),q===i.UNSIGNED_INT&&(et=i.RG32UI),q===i.BYTE&&(et=i.RG8I),q===i.SHORT&&(et=i.RG16I),q===i.INT&&(et=i.RG32I)),b===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.RGB8UI),q===i.UNSIGNED_SHORT&&(et=i.RGB16UI),q===i.UNSIGNED_INT&&(et=i.RGB32UI),q===i.BYTE&&(et=i.RGB8I),q===i.SHORT&&(et=i.RGB16I),q===i.INT&&(et=i.RGB32I)),b===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),q===i.UNSIGNED_INT&&(et=i.RGBA32UI),q===i.BYTE&&(et=i.RGBA8I),q===i.SHORT&&(et=i.RGBA16I),q===i.INT&&(et=i.RGBA32I)),b===i.RGB&&(q===i.UNSIGNED_SHORT&&xt&&(et=xt.RGB16_EXT),q===i.SHORT&&xt&&(et=xt.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),b===i.RGBA){let it=yt?Ga:_e.getTransfer(ot);q===i.FLOAT&&(et=i.RGBA32F),q===i.HALF_FLOAT&&(et=i.RGBA16F),q===i.UNSIGNED_BYTE&&(et=it===Ee?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&xt&&(et=xt.RGBA16_EXT),q===i.SHORT&&xt&&(et=xt.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function _(R,b){let q;return R?b===null||b===Ui||b===kr?q=i.DEPTH24_STENCIL8:b===Oi?q=i.DEPTH32F_STENCIL8:b===Jo&&(q=i.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Ui||b===kr?q=i.DEPTH_COMPONENT24:b===Oi?q=i.DEPTH_COMPONENT32F:b===Jo&&(q=i.DEPTH_COMPONENT16),q}function T(R,b){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Cn&&R.minFilter!==Yn?Math.log2(Math.max(b.width,b.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?b.mipmaps.length:1}function k(R){let b=new WeakRef(R);n.get(R).__ref=b,p.add(b),x.register(R,b,b)}function F(R){let b=n.get(R).__ref;b!==void 0&&(p.delete(b),x.unregister(b))}function D(R){W(R.target)}function H(R){L(R.target)}function W(R){R.removeEventListener("dispose",D),F(R),Y(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function L(R){R.removeEventListener("dispose",H),F(R),ct(R)}function X(){for(let R of p){let b=R.deref();b!==void 0&&(b.isRenderTarget===!0?L(b):W(b))}p.clear(),u.clear()}function Y(R){let b=n.get(R);if(b.__webglInit===void 0)return;let q=R.source,ht=f.get(q);if(ht){let ot=ht[b.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&G(R),Object.keys(ht).length===0&&f.delete(q)}n.remove(R)}function G(R){let b=n.get(R);i.deleteTexture(b.__webglTexture);let q=R.source,ht=f.get(q);delete ht[b.__cacheKey],o.memory.textures--}function ct(R){let b=n.get(R);b.__depthDisposeCallback&&b.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&W(q),R.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(b.__webglFramebuffer[ot]))for(let yt=0;yt<b.__webglFramebuffer[ot].length;yt++)i.deleteFramebuffer(b.__webglFramebuffer[ot][yt]);else i.deleteFramebuffer(b.__webglFramebuffer[ot]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[ot])}else{if(Array.isArray(b.__webglFramebuffer))for(let ot=0;ot<b.__webglFramebuffer.length;ot++)i.deleteFramebuffer(b.__webglFramebuffer[ot]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let ot=0;ot<b.__webglColorRenderbuffer.length;ot++)b.__webglColorRenderbuffer[ot]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[ot]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ht=R.textures;for(let ot=0,yt=ht.length;ot<yt;ot++){let xt=n.get(ht[ot]);xt.__webglTexture&&(i.deleteTexture(xt.__webglTexture),o.memory.textures--),n.remove(ht[ot])}n.remove(R)}let K=0;function Q(){K=0}function st(){return K}function dt(R){K=R}function ut(){let R=K;return R>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,R}function tt(R){let b=[];return b.push(R.wrapS),b.push(R.wrapT),b.push(R.wrapR||0),b.push(R.magFilter),b.push(R.minFilter),b.push(R.anisotropy),b.push(R.internalFormat),b.push(R.format),b.push(R.type),b.push(R.generateMipmaps),b.push(R.mipmapsAutoUpdate),b.push(R.premultiplyAlpha),b.push(R.flipY),b.push(R.unpackAlignment),b.push(R.colorSpace),b.join()}function mt(R,b){let q=n.get(R);if(R.isVideoTexture&&Le(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ht=R.image;if(ht===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{Ue(q,R,b);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+b)}function _t(R,b){let q=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ue(q,R,b);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+b)}function At(R,b){let q=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Ue(q,R,b);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+b)}function St(R,b){let q=n.get(R);if(R.version>0&&q.__version!==R.version){an(q,R,b);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+b)}let Wt={[uh]:i.REPEAT,[ts]:i.CLAMP_TO_EDGE,[dh]:i.MIRRORED_REPEAT},ie={[Cn]:i.NEAREST,[$y]:i.NEAREST_MIPMAP_NEAREST,[fl]:i.NEAREST_MIPMAP_LINEAR,[Yn]:i.LINEAR,[qh]:i.LINEAR_MIPMAP_NEAREST,[Is]:i.LINEAR_MIPMAP_LINEAR},Vt={[Ky]:i.NEVER,[gp]:i.ALWAYS,[jy]:i.LESS,[pp]:i.LEQUAL,[Qy]:i.EQUAL,[mp]:i.GEQUAL,[t_]:i.GREATER,[e_]:i.NOTEQUAL};function de(R,b){if(b.type===Oi&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Yn||b.magFilter===qh||b.magFilter===fl||b.magFilter===Is||b.minFilter===Yn||b.minFilter===qh||b.minFilter===fl||b.minFilter===Is)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Wt[b.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Wt[b.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Wt[b.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,ie[b.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,ie[b.minFilter]),b.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Vt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Cn||b.minFilter!==fl&&b.minFilter!==Is||b.type===Oi&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function oe(R,b){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,b.addEventListener("dispose",D),k(b));let ht=b.source,ot=f.get(ht);ot===void 0&&(ot={},f.set(ht,ot));let yt=tt(b);if(yt!==R.__cacheKey){ot[yt]===void 0&&(ot[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ot[yt].usedTimes++;let xt=ot[R.__cacheKey];xt!==void 0&&(ot[R.__cacheKey].usedTimes--,xt.usedTimes===0&&G(b)),R.__cacheKey=yt,R.__webglTexture=ot[yt].texture}return q}function ee(R,b,q){return Math.floor(Math.floor(R/q)/b)}function qe(R,b,q,ht){let yt=R.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,q,ht,b.data);else{yt.sort((U,rt)=>U.start-rt.start);let xt=0;for(let U=1;U<yt.length;U++){let rt=yt[xt],nt=yt[U],wt=rt.start+rt.count,gt=ee(nt.start,b.width,4),bt=ee(rt.start,b.width,4);nt.start<=wt+1&&gt===bt&&ee(nt.start+nt.count-1,b.width,4)===gt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++xt,yt[xt]=nt)}yt.length=xt+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),it=e.getParameter(i.UNPACK_SKIP_PIXELS),pt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let U=0,rt=yt.length;U<rt;U++){let nt=yt[U],wt=Math.floor(nt.start/4),gt=Math.ceil(nt.count/4),bt=wt%b.width,Gt=Math.floor(wt/b.width),Jt=gt,lt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(i.TEXTURE_2D,0,bt,Gt,Jt,lt,q,ht,b.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,it),e.pixelStorei(i.UNPACK_SKIP_ROWS,pt)}}function Ue(R,b,q){let ht=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ht=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ht=i.TEXTURE_3D);let ot=oe(R,b),yt=b.source;e.bindTexture(ht,R.__webglTexture,i.TEXTURE0+q);let xt=n.get(yt);if(yt.version!==xt.__version||ot===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let lt=_e.getPrimaries(_e.workingColorSpace),kt=b.colorSpace===Ds?null:_e.getPrimaries(b.colorSpace),Kt=b.colorSpace===Ds||lt===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let it=v(b.image,!1,s.maxTextureSize);it=Ht(b,it);let pt=r.convert(b.format,b.colorSpace),U=r.convert(b.type),rt=E(b.internalFormat,pt,U,b.normalized,b.colorSpace,b.isVideoTexture);de(ht,b);let nt,wt=b.mipmaps,gt=b.isVideoTexture!==!0,bt=xt.__version===void 0||ot===!0,Gt=yt.dataReady,Jt=T(b,it);if(b.isDepthTexture)rt=_(b.format===Ls,b.type),bt&&(gt?e.texStorage2D(i.TEXTURE_2D,1,rt,it.width,it.height):e.texImage2D(i.TEXTURE_2D,0,rt,it.width,it.height,0,pt,U,null));else if(b.isDataTexture)if(wt.length>0){gt&&bt&&e.texStorage2D(i.TEXTURE_2D,Jt,rt,wt[0].width,wt[0].height);for(let lt=0,kt=wt.length;lt<kt;lt++)nt=wt[lt],gt?Gt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,nt.width,nt.height,pt,U,nt.data):e.texImage2D(i.TEXTURE_2D,lt,rt,nt.width,nt.height,0,pt,U,nt.data);b.generateMipmaps=!1}else gt?(bt&&e.texStorage2D(i.TEXTURE_2D,Jt,rt,it.width,it.height),Gt&&qe(b,it,pt,U)):e.texImage2D(i.TEXTURE_2D,0,rt,it.width,it.height,0,pt,U,it.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){gt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Jt,rt,wt[0].width,wt[0].height,it.depth);for(let lt=0,kt=wt.length;lt<kt;lt++)if(nt=wt[lt],b.format!==Bi)if(pt!==null)if(gt){if(Gt)if(b.layerUpdates.size>0){let Kt=Rp(nt.width,nt.height,b.format,b.type);for(let Rt of b.layerUpdates){let re=nt.data.subarray(Rt*Kt/nt.data.BYTES_PER_ELEMENT,(Rt+1)*Kt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,Rt,nt.width,nt.height,1,pt,re)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,nt.width,nt.height,it.depth,pt,nt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,lt,rt,nt.width,nt.height,it.depth,0,nt.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Gt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,lt,0,0,0,nt.width,nt.height,it.depth,pt,U,nt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,lt,rt,nt.width,nt.height,it.depth,0,pt,U,nt.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{gt&&bt&&e.texStorage2D(i.TEXTURE_2D,Jt,rt,wt[0].width,wt[0].height);for(let lt=0,kt=wt.length;lt<kt;lt++)nt=wt[lt],b.format!==Bi?pt!==null?gt?Gt&&e.compressedTexSubImage2D(i.TEXTURE_2D,lt,0,0,nt.width,nt.height,pt,nt.data):e.compressedTexImage2D(i.TEXTURE_2D,lt,rt,nt.width,nt.height,0,nt.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Gt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,nt.width,nt.height,pt,U,nt.data):e.texImage2D(i.TEXTURE_2D,lt,rt,nt.width,nt.height,0,pt,U,nt.data)}else if(b.isDataArrayTexture)if(gt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Jt,rt,it.width,it.height,it.depth),Gt)if(b.layerUpdates.size>0){let lt=Rp(it.width,it.height,b.format,b.type);for(let kt of b.layerUpdates){let Kt=it.data.subarray(kt*lt/it.data.BYTES_PER_ELEMENT,(kt+1)*lt/it.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,it.width,it.height,1,pt,U,Kt)}b.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,it.width,it.height,it.depth,pt,U,it.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,it.width,it.height,it.depth,0,pt,U,it.data);else if(b.isData3DTexture)gt?(bt&&e.texStorage3D(i.TEXTURE_3D,Jt,rt,it.width,it.height,it.depth),Gt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,it.width,it.height,it.depth,pt,U,it.data)):e.texImage3D(i.TEXTURE_3D,0,rt,it.width,it.height,it.depth,0,pt,U,it.data);else if(b.isFramebufferTexture){if(bt)if(gt)e.texStorage2D(i.TEXTURE_2D,Jt,rt,it.width,it.height);else{let lt=it.width,kt=it.height;for(let Kt=0;Kt<Jt;Kt++)e.texImage2D(i.TEXTURE_2D,Kt,rt,lt,kt,0,pt,U,null),lt>>=1,kt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let lt=i.canvas;if(lt.hasAttribute("layoutsubtree")||lt.setAttribute("layoutsubtree","true"),it.parentNode!==lt){lt.appendChild(it),u.add(b),lt.onpaint=kt=>{let Kt=kt.changedElements;for(let Rt of u)Kt.includes(Rt.image)&&(Rt.needsUpdate=!0)},lt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,it);else{let Kt=i.RGBA,Rt=i.RGBA,re=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Kt,Rt,re,it)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&bt){let lt=qt(wt[0]);e.texStorage2D(i.TEXTURE_2D,Jt,rt,lt.width,lt.height)}for(let lt=0,kt=wt.length;lt<kt;lt++)nt=wt[lt],gt?Gt&&e.texSubImage2D(i.TEXTURE_2D,lt,0,0,pt,U,nt):e.texImage2D(i.TEXTURE_2D,lt,rt,pt,U,nt);b.generateMipmaps=!1}else if(gt){if(bt){let lt=qt(it);e.texStorage2D(i.TEXTURE_2D,Jt,rt,lt.width,lt.height)}Gt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,pt,U,it)}else e.texImage2D(i.TEXTURE_2D,0,rt,pt,U,it);A(b)&&b.mipmapsAutoUpdate===!0&&S(ht),xt.__version=yt.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function an(R,b,q){if(b.image.length!==6)return;let ht=oe(R,b),ot=b.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+q);let yt=n.get(ot);if(ot.version!==yt.__version||ht===!0){e.activeTexture(i.TEXTURE0+q);let xt=_e.getPrimaries(_e.workingColorSpace),et=b.colorSpace===Ds?null:_e.getPrimaries(b.colorSpace),it=b.colorSpace===Ds||xt===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,it);let pt=b.isCompressedTexture||b.image[0].isCompressedTexture,U=b.image[0]&&b.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!pt&&!U?rt[Rt]=v(b.image[Rt],!0,s.maxCubemapSize):rt[Rt]=U?b.image[Rt].image:b.image[Rt],rt[Rt]=Ht(b,rt[Rt]);let nt=rt[0],wt=r.convert(b.format,b.colorSpace),gt=r.convert(b.type),bt=E(b.internalFormat,wt,gt,b.normalized,b.colorSpace),Gt=b.isVideoTexture!==!0,Jt=yt.__version===void 0||ht===!0,lt=ot.dataReady,kt=T(b,nt);de(i.TEXTURE_CUBE_MAP,b);let Kt;if(b.isDepthTexture){if(bt=_(b.format===Ls,b.type),Jt)if(Gt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,nt.width,nt.height,0,wt,gt,null)}else if(pt){Gt&&Jt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,bt,nt.width,nt.height);for(let Rt=0;Rt<6;Rt++){Kt=rt[Rt].mipmaps;for(let re=0;re<Kt.length;re++){let Be=Kt[re];b.format!==Bi?wt!==null?Gt?lt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re,0,0,Be.width,Be.height,wt,Be.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re,bt,Be.width,Be.height,0,Be.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re,0,0,Be.width,Be.height,wt,gt,Be.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re,bt,Be.width,Be.height,0,wt,gt,Be.data)}}}else{if(Kt=b.mipmaps,Gt&&Jt){Kt.length>0&&kt++;let Rt=qt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,bt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(U){Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,wt,gt,rt[Rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,rt[Rt].width,rt[Rt].height,0,wt,gt,rt[Rt].data);for(let re=0;re<Kt.length;re++){let zn=Kt[re].image[Rt].image;Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re+1,0,0,zn.width,zn.height,wt,gt,zn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re+1,bt,zn.width,zn.height,0,wt,gt,zn.data)}}else{Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,wt,gt,rt[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,wt,gt,rt[Rt]);for(let re=0;re<Kt.length;re++){let Be=Kt[re];Gt?lt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re+1,0,0,wt,gt,Be.image[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,re+1,bt,wt,gt,Be.image[Rt])}}}A(b)&&b.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=ot.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function Pe(R,b,q,ht,ot,yt){let xt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),it=E(q.internalFormat,xt,et,q.normalized,q.colorSpace),pt=n.get(b),U=n.get(q);if(U.__renderTarget=b,!pt.__hasExternalTextures){let rt=Math.max(1,b.width>>yt),nt=Math.max(1,b.height>>yt);ot===i.TEXTURE_3D||ot===i.TEXTURE_2D_ARRAY?e.texImage3D(ot,yt,it,rt,nt,b.depth,0,xt,et,null):e.texImage2D(ot,yt,it,rt,nt,0,xt,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),Mt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ht,ot,U.__webglTexture,0,se(b)):(ot===i.TEXTURE_2D||ot>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ht,ot,U.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Mn(R,b,q){if(i.bindRenderbuffer(i.RENDERBUFFER,R),b.depthBuffer){let ht=b.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,yt=_(b.stencilBuffer,ot),xt=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Mt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,se(b),yt,b.width,b.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,se(b),yt,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,yt,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,xt,i.RENDERBUFFER,R)}else{let ht=b.textures;for(let ot=0;ot<ht.length;ot++){let yt=ht[ot],xt=r.convert(yt.format,yt.colorSpace),et=r.convert(yt.type),it=E(yt.internalFormat,xt,et,yt.normalized,yt.colorSpace);Mt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,se(b),it,b.width,b.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,se(b),it,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,it,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(R,b,q){let ht=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=n.get(b.depthTexture);ot.__renderTarget=b;let yt=ht?b.depthTexture.image[0]:b.depthTexture.image;(!ot.__webglTexture||yt.width!==b.width||yt.height!==b.height)&&(yt.width=b.width,yt.height=b.height,b.depthTexture.needsUpdate=!0),ht?St(b.depthTexture,0):mt(b.depthTexture,0);let xt=ot.__webglTexture,et=se(b),it=ht?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,pt=b.depthTexture.format===Ls?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Ts)Mt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,it,xt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,pt,it,xt,0);else if(b.depthTexture.format===Ls)Mt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pt,it,xt,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,pt,it,xt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(R){let b=n.get(R),q=R.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==R.depthTexture){let ht=R.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ht){let ot=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),b.__depthDisposeCallback=ot}b.__boundDepthTexture=ht}if(R.depthTexture&&!b.__autoAllocateDepthBuffer)if(q)for(let ht=0;ht<6;ht++)xe(b.__webglFramebuffer[ht],R,ht);else R.texture.mipmaps.length>0?xe(b.__webglFramebuffer[0],R,0):xe(b.__webglFramebuffer,R,0);else if(q){b.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[ht]),b.__webglDepthbuffer[ht]===void 0)b.__webglDepthbuffer[ht]=i.createRenderbuffer(),Mn(b.__webglDepthbuffer[ht],R,!1);else{let ot=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=b.__webglDepthbuffer[ht];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,yt)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Mn(b.__webglDepthbuffer,R,!1);else{let ot=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Qe(R,b,q){let ht=n.get(R);b!==void 0&&Pe(ht.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&mn(R)}function ln(R){let b=R.texture,q=n.get(R),ht=n.get(b);R.addEventListener("dispose",H),k(R);let ot=R.textures,yt=R.isWebGLCubeRenderTarget===!0,xt=ot.length>1;if(xt||(ht.__webglTexture===void 0&&(ht.__webglTexture=i.createTexture()),ht.__version=b.version,o.memory.textures++),yt){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(b.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let it=0;it<b.mipmaps.length;it++)q.__webglFramebuffer[et][it]=i.createFramebuffer()}else q.__webglFramebuffer[et]=i.createFramebuffer()}else{if(b.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<b.mipmaps.length;et++)q.__webglFramebuffer[et]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(xt)for(let et=0,it=ot.length;et<it;et++){let pt=n.get(ot[et]);pt.__webglTexture===void 0&&(pt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Mt(R)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let it=ot[et];q.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let pt=r.convert(it.format,it.colorSpace),U=r.convert(it.type),rt=E(it.internalFormat,pt,U,it.normalized,it.colorSpace,R.isXRRenderTarget===!0),nt=se(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,nt,rt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,q.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Mn(q.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,ht.__webglTexture),de(i.TEXTURE_CUBE_MAP,b);for(let et=0;et<6;et++)if(b.mipmaps.length>0)for(let it=0;it<b.mipmaps.length;it++)Pe(q.__webglFramebuffer[et][it],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,it);else Pe(q.__webglFramebuffer[et],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);A(b)?S(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(xt){for(let et=0,it=ot.length;et<it;et++){let pt=ot[et],U=n.get(pt),rt=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(rt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,U.__webglTexture),de(rt,pt),Pe(q.__webglFramebuffer,R,pt,i.COLOR_ATTACHMENT0+et,rt,0),A(pt)&&S(rt)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(et=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),de(et,b),b.mipmaps.length>0)for(let it=0;it<b.mipmaps.length;it++)Pe(q.__webglFramebuffer[it],R,b,i.COLOR_ATTACHMENT0,et,it);else Pe(q.__webglFramebuffer,R,b,i.COLOR_ATTACHMENT0,et,0);A(b)?S(et):b.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&mn(R)}function O(R){let b=R.textures;for(let q=0,ht=b.length;q<ht;q++){let ot=b[q];if(A(ot)&&ot.mipmapsAutoUpdate===!0){let yt=C(R),xt=n.get(ot).__webglTexture;e.bindTexture(yt,xt),S(yt),e.unbindTexture()}}}let Ct=[];function Yt(R){if(R.samples>0){if(Mt(R)===!1){let b=R.textures,q=R.width,ht=R.height,ot=i.COLOR_BUFFER_BIT,yt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xt=n.get(R),et=b.length>1;if(et)for(let pt=0;pt<b.length;pt++)e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,xt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,xt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,xt.__webglFramebuffer);for(let pt=0;pt<b.length;pt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ot|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ot|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,xt.__webglColorRenderbuffer[pt]);let U=n.get(b[pt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,q,ht,0,0,q,ht,ot,i.NEAREST),l===!0&&(Ct.length=0,Ct.push(i.COLOR_ATTACHMENT0+pt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ct.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let pt=0;pt<b.length;pt++){e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.RENDERBUFFER,xt.__webglColorRenderbuffer[pt]);let U=n.get(b[pt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,xt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pt,i.TEXTURE_2D,U,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,xt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let b=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function se(R){return Math.min(s.maxSamples,R.samples)}function Mt(R){let b=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Le(R){let b=o.render.frame;h.get(R)!==b&&(h.set(R,b),R.update())}function Ht(R,b){let q=R.colorSpace,ht=R.format,ot=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Va&&q!==Ds&&(_e.getTransfer(q)===Ee?(ht!==Bi||ot!==jn)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",q)),b}function qt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=Q,this.getTextureUnits=st,this.setTextureUnits=dt,this.setTexture2D=mt,this.setTexture2DArray=_t,this.setTexture3D=At,this.setTextureCube=St,this.rebindTextures=Qe,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=Pe,this.useMultisampledRTT=Mt,this.dispose=X}function yA(i,t){function e(n,s=Ds){let r,o=_e.getTransfer(s);if(n===jn)return i.UNSIGNED_BYTE;if(n===Yh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Zh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===cp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===hp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ap)return i.BYTE;if(n===lp)return i.SHORT;if(n===Jo)return i.UNSIGNED_SHORT;if(n===$h)return i.INT;if(n===Ui)return i.UNSIGNED_INT;if(n===Oi)return i.FLOAT;if(n===ki)return i.HALF_FLOAT;if(n===up)return i.ALPHA;if(n===dp)return i.RGB;if(n===Bi)return i.RGBA;if(n===Ts)return i.DEPTH_COMPONENT;if(n===Ls)return i.DEPTH_STENCIL;if(n===fp)return i.RED;if(n===Jh)return i.RED_INTEGER;if(n===cr)return i.RG;if(n===Kh)return i.RG_INTEGER;if(n===jh)return i.RGBA_INTEGER;if(n===pl||n===ml||n===gl||n===yl)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===pl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===pl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ml)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===gl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===yl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Qh||n===tu||n===eu||n===nu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Qh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===tu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===eu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===nu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===iu||n===su||n===ru||n===ou||n===au||n===_l||n===lu)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===iu||n===su)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ru)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ou)return r.COMPRESSED_R11_EAC;if(n===au)return r.COMPRESSED_SIGNED_R11_EAC;if(n===_l)return r.COMPRESSED_RG11_EAC;if(n===lu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===cu||n===hu||n===uu||n===du||n===fu||n===pu||n===mu||n===gu||n===yu||n===_u||n===xu||n===vu||n===bu||n===Su)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===cu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===hu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===uu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===du)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===fu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===pu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===mu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===gu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===yu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===_u)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===xu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===vu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===bu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Su)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Mu||n===wu||n===Tu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Mu)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===wu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Tu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Eu||n===Au||n===xl||n===Ru)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Eu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Au)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===xl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Ru)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===kr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var _A=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,xA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Op=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Qa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new is({vertexShader:_A,fragmentShader:xA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Xe(new nl(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kp=class extends Fi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Op,g={},v=e.getContextAttributes(),A=null,S=null,C=[],E=[],_=new Ot,T=null,k=null,F=new $n;F.viewport=new Ye;let D=new $n;D.viewport=new Ye;let H=[F,D],W=new Vh,L=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Ho,C[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Ho,C[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=C[tt];return mt===void 0&&(mt=new Ho,C[tt]=mt),mt.getHandSpace()};function Y(tt){let mt=E.indexOf(tt.inputSource);if(mt===-1)return;let _t=C[mt];_t!==void 0&&(_t.update(tt.inputSource,tt.frame,c||o),_t.dispatchEvent({type:tt.type,data:tt.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<C.length;tt++){let mt=E[tt];mt!==null&&(E[tt]=null,C[tt].disconnect(mt))}L=null,X=null,m.reset();for(let tt in g)delete g[tt];if(t.setRenderTarget(A),f=null,d=null,u=null,s=null,S=null,ut.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),k!==null){let tt=k.camera;tt.fov=k.fov,tt.zoom=k.zoom,tt.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ct),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,At=null,St=null;v.depth&&(St=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=v.stencil?Ls:Ts,At=v.stencil?kr:Ui);let Wt={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Wt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),S=new di(d.textureWidth,d.textureHeight,{format:Bi,type:jn,depthTexture:new Ps(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _t={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new di(f.framebufferWidth,f.framebufferHeight,{format:Bi,type:jn,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(tt){for(let mt=0;mt<tt.removed.length;mt++){let _t=tt.removed[mt],At=E.indexOf(_t);At>=0&&(E[At]=null,C[At].disconnect(_t))}for(let mt=0;mt<tt.added.length;mt++){let _t=tt.added[mt],At=E.indexOf(_t);if(At===-1){for(let Wt=0;Wt<C.length;Wt++)if(Wt>=E.length){E.push(_t),At=Wt;break}else if(E[Wt]===null){E[Wt]=_t,At=Wt;break}if(At===-1)break}let St=C[At];St&&St.connect(_t)}}function K(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,_t=tt.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(_t=m.depthFar)),W.near=D.near=F.near=mt,W.far=D.far=F.far=_t,(L!==W.near||X!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),L=W.near,X=W.far),W.layers.mask=tt.layers.mask|6,F.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let At=tt.parent,St=W.cameras;K(W,At);for(let Wt=0;Wt<St.length;Wt++)K(St[Wt],At);W.projectionMatrix.copy(F.projectionMatrix),W.projectionMatrixInverse.copy(F.projectionMatrixInverse),k===null&&tt.isPerspectiveCamera&&(k={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,W,At)};function Q(tt,mt,_t){_t===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(_t.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Bo*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(tt){return g[tt]};let st=null;function dt(tt,mt){if(h=mt.getViewerPose(c||o),p=mt,h!==null){let _t=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let At=!1;_t.length!==W.cameras.length&&(W.cameras.length=0,At=!0);for(let Vt=0;Vt<_t.length;Vt++){let de=_t[Vt],oe=null;if(f!==null)oe=f.getViewport(de);else{let qe=u.getViewSubImage(d,de);oe=qe.viewport,Vt===0&&(t.setRenderTargetTextures(S,qe.colorTexture,qe.depthStencilTexture),t.setRenderTarget(S))}let ee=H[Vt];ee===void 0&&(ee=new $n,ee.layers.enable(Vt),ee.viewport=new Ye,H[Vt]=ee),ee.matrix.fromArray(de.transform.matrix),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.projectionMatrix.fromArray(de.projectionMatrix),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert(),ee.viewport.set(oe.x,oe.y,oe.width,oe.height),Vt===0&&(W.matrix.copy(ee.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),At===!0&&W.cameras.push(ee)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Vt=u.getDepthInformation(_t[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(St&&St.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Vt=0;Vt<_t.length;Vt++){let de=_t[Vt].camera;if(de){let oe=g[de];oe||(oe=new Qa,g[de]=oe);let ee=u.getCameraImage(de);oe.sourceTexture=ee}}}}for(let _t=0;_t<C.length;_t++){let At=E[_t],St=C[_t];At!==null&&St!==void 0&&St.update(At,mt,c||o)}st&&st(tt,mt),mt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:mt}),p=null}let ut=new N_;ut.setAnimationLoop(dt),this.setAnimationLoop=function(tt){st=tt},this.dispose=function(){}}},vA=new Oe,W_=new te;W_.set(-1,0,0,0,1,0,0,0,1);function bA(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,Tp(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,A,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,v,A):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Zn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Zn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=t.get(g),A=v.envMap,S=v.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(vA.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(W_),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,v,A){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=A*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Zn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let v=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function SA(i,t,e,n){let s={},r={};function o(v,A){let S=A.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,A){let S=s[v.id];S===void 0&&(p(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",m));let C=A.program;n.updateUBOMapping(v,C);let E=t.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let A=i.createBuffer(),S=v.__size,C=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,S,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],S=v.uniforms,C=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,_=S.length;E<_;E++){let T=S[E];if(Array.isArray(T))for(let k=0,F=T.length;k<F;k++)h(T[k],E,k,C);else h(T,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,A,S,C){if(d(v,A,S,C)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let T=0;for(let k=0;k<_.length;k++){let F=_[k],D=x(F,!0);u(F,v.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function u(v,A,S){typeof v=="number"||typeof v=="boolean"?A[S]=v:v.isMatrix3?(A[S]=v.elements[0],A[S+1]=v.elements[1],A[S+2]=v.elements[2],A[S+3]=0,A[S+4]=v.elements[3],A[S+5]=v.elements[4],A[S+6]=v.elements[5],A[S+7]=0,A[S+8]=v.elements[6],A[S+9]=v.elements[7],A[S+10]=v.elements[8],A[S+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-S),S):v.toArray(A,S)}function d(v,A,S,C){let E=v.value,_=A+"_"+S;if(Array.isArray(E)){C[_]===void 0&&(C[_]=[]);let T=C[_],k=!1;for(let F=0;F<E.length;F++)f(E[F],T,F)===!0&&(k=!0);return k}return f(E,C,_)}function f(v,A,S){if(A[S]===void 0)return typeof v=="number"||typeof v=="boolean"?A[S]=v:ArrayBuffer.isView(v)?A[S]=v.slice():A[S]=v.clone(),!0;{let C=A[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return A[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function p(v){let A=v.uniforms,S=0,C=16;for(let _=0,T=A.length;_<T;_++){let k=Array.isArray(A[_])?A[_]:[A[_]];for(let F=0,D=k.length;F<D;F++){let H=k[F],W=Array.isArray(H.value)?H.value:[H.value],L=Array.isArray(A[_])||Array.isArray(H.value),X=S;for(let G=0,ct=W.length;G<ct;G++){let K=W[G],Q=x(K,L),st=S%C,dt=st%Q.boundary,ut=st+dt;S+=dt,ut!==0&&C-ut<Q.storage&&(S+=C-ut),G===0&&(X=S),S+=Q.storage}let Y=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new Y((S-X)/Float32Array.BYTES_PER_ELEMENT),H.__offset=X}}let E=S%C;return E>0&&(S+=C-E),v.__size=S,v.__cache={},this}function x(v,A){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let A=v.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var MA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),os=null;function wA(){return os===null&&(os=new yh(MA,16,16,cr,ki),os.name="DFG_LUT",os.minFilter=Yn,os.magFilter=Yn,os.wrapS=ts,os.wrapT=ts,os.generateMipmaps=!1,os.needsUpdate=!0),os}var Du=class{constructor(t={}){let{canvas:e=i_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=jn}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([jh,Kh,Jh]),g=new Set([jn,Ui,Jo,kr,Yh,Zh]),v=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,E=null,_=[],T=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=rs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,D=!1,H=null,W=null,L=null,X=null;this._outputColorSpace=ci;let Y=0,G=0,ct=null,K=-1,Q=null,st=new Ye,dt=new Ye,ut=null,tt=new he(0),mt=0,_t=e.width,At=e.height,St=1,Wt=null,ie=null,Vt=new Ye(0,0,_t,At),de=new Ye(0,0,_t,At),oe=!1,ee=new er,qe=new _h,Ue=!1,an=!1,Pe=new Oe,Mn=new z,xe=new Ye,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qe=!1;function ln(){return ct===null?St:1}let O=n;function Ct(w,B){return e.getContext(w,B)}let Yt,se,Mt,Le,Ht,qt,R,b,q,ht,ot,yt,xt,et,it,pt,U,rt,nt,wt,gt,bt,Gt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),O===null){let B="webgl2";if(O=Ct(B,w),O===null)throw Ct(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Jt()}catch(w){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),Qt("WebGLRenderer: "+w.message),w}function Jt(){Yt=new F1(O),Yt.init(),gt=new yA(O,Yt),se=new w1(O,Yt,t,gt),Mt=new mA(O,Yt),se.reversedDepthBuffer&&d&&Mt.buffers.depth.setReversed(!0),W=O.createFramebuffer(),L=O.createFramebuffer(),X=O.createFramebuffer(),Le=new k1(O),Ht=new eA,qt=new gA(O,Yt,Mt,Ht,se,gt,Le),R=new N1(F),b=new zM(O),bt=new S1(O,b),q=new U1(O,b,Le,bt),ht=new z1(O,q,b,bt,Le),rt=new B1(O,se,qt),it=new T1(Ht),ot=new tA(F,R,Yt,se,bt,it),yt=new bA(F,Ht),xt=new iA,et=new cA(Yt),U=new b1(F,R,Mt,ht,p,l),pt=new pA(F,ht,se),Gt=new SA(O,Le,se,Mt),nt=new M1(O,Yt,Le),wt=new O1(O,Yt,Le),Le.programs=ot.programs,F.capabilities=se,F.extensions=Yt,F.properties=Ht,F.renderLists=xt,F.shadowMap=pt,F.state=Mt,F.info=Le}x!==jn&&(k=new V1(x,e.width,e.height,a,s,r));let lt=new kp(F,O);this.xr=lt,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let w=Yt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Yt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return St},this.setPixelRatio=function(w){w!==void 0&&(St=w,this.setSize(_t,At,!1))},this.getSize=function(w){return w.set(_t,At)},this.setSize=function(w,B,j=!0){if(lt.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=w,At=B,e.width=Math.floor(w*St),e.height=Math.floor(B*St),j===!0&&(e.style.width=w+"px",e.style.height=B+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,B)},this.getDrawingBufferSize=function(w){return w.set(_t*St,At*St).floor()},this.setDrawingBufferSize=function(w,B,j){_t=w,At=B,St=j,e.width=Math.floor(w*j),e.height=Math.floor(B*j),this.setViewport(0,0,w,B)},this.setEffects=function(w){if(x===jn){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let B=0;B<w.length;B++)if(w[B].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(st)},this.getViewport=function(w){return w.copy(Vt)},this.setViewport=function(w,B,j,$){w.isVector4?Vt.set(w.x,w.y,w.z,w.w):Vt.set(w,B,j,$),Mt.viewport(st.copy(Vt).multiplyScalar(ln()).round())},this.getScissor=function(w){return w.copy(de)},this.setScissor=function(w,B,j,$){w.isVector4?de.set(w.x,w.y,w.z,w.w):de.set(w,B,j,$),Mt.scissor(dt.copy(de).multiplyScalar(ln()).round())},this.getScissorTest=function(){return oe},this.setScissorTest=function(w){Mt.setScissorTest(oe=w)},this.setOpaqueSort=function(w){Wt=w},this.setTransparentSort=function(w){ie=w},this.getClearColor=function(w){return w.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(w=!0,B=!0,j=!0){let $=0;if(w){let Z=!1;if(ct!==null){let Tt=ct.texture.format;Z=m.has(Tt)}if(Z){let Tt=ct.texture.type,Pt=g.has(Tt),Et=U.getClearColor(),It=U.getClearAlpha(),zt=Et.r,jt=Et.g,fe=Et.b;Pt?(v[0]=zt,v[1]=jt,v[2]=fe,v[3]=It,O.clearBufferuiv(O.COLOR,0,v)):(A[0]=zt,A[1]=jt,A[2]=fe,A[3]=It,O.clearBufferiv(O.COLOR,0,A))}else $|=O.COLOR_BUFFER_BIT}B&&($|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&O.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),H=w},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),U.dispose(),xt.dispose(),et.dispose(),qt.dispose(),Ht.dispose(),R.dispose(),ht.dispose(),q.dispose(),bt.dispose(),Gt.dispose(),ot.dispose(),lt.dispose(),lt.removeEventListener("sessionstart",El),lt.removeEventListener("sessionend",zi),ls.stop()};function kt(w){w.preventDefault(),xp("WebGLRenderer: Context Lost."),D=!0}function Kt(){xp("WebGLRenderer: Context Restored."),D=!1;let w=Le.autoReset,B=pt.enabled,j=pt.autoUpdate,$=pt.needsUpdate,Z=pt.type;Jt(),Le.autoReset=w,pt.enabled=B,pt.autoUpdate=j,pt.needsUpdate=$,pt.type=Z}function Rt(w){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function re(w){let B=w.target;B.removeEventListener("dispose",re),Be(B)}function Be(w){zn(w),Ht.remove(w)}function zn(w){let B=Ht.get(w).programs;B!==void 0&&(B.forEach(function(j){ot.releaseProgram(j)}),w.isShaderMaterial&&ot.releaseShaderCache(w))}this.renderBufferDirect=function(w,B,j,$,Z,Tt){B===null&&(B=mn);let Pt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Et=ra(w,B,j,$,Z);Mt.setMaterial($,Pt);let It=j.index,zt=1;if($.wireframe===!0){if(It=q.getWireframeAttribute(j),It===void 0)return;zt=2}let jt=j.drawRange,fe=j.attributes.position,Bt=jt.start*zt,pe=(jt.start+jt.count)*zt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*zt),pe=Math.min(pe,(Tt.start+Tt.count)*zt)),It!==null?(Bt=Math.max(Bt,0),pe=Math.min(pe,It.count)):fe!=null&&(Bt=Math.max(Bt,0),pe=Math.min(pe,fe.count));let Ze=pe-Bt;if(Ze<0||Ze===1/0)return;bt.setup(Z,$,Et,j,It);let Ae,Re=nt;if(It!==null&&(Ae=b.get(It),Re=wt,Re.setIndex(Ae)),Z.isMesh)$.wireframe===!0?(Mt.setLineWidth($.wireframeLinewidth*ln()),Re.setMode(O.LINES)):Re.setMode(O.TRIANGLES);else if(Z.isLine){let gn=$.linewidth;gn===void 0&&(gn=1),Mt.setLineWidth(gn*ln()),Z.isLineSegments?Re.setMode(O.LINES):Z.isLineLoop?Re.setMode(O.LINE_LOOP):Re.setMode(O.LINE_STRIP)}else Z.isPoints?Re.setMode(O.POINTS):Z.isSprite&&Re.setMode(O.TRIANGLES);if(Z.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))Re.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let gn=Z._multiDrawStarts,Ft=Z._multiDrawCounts,cn=Z._multiDrawCount,ge=It?b.get(It).bytesPerElement:1,hs=Ht.get($).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)hs.setValue(O,"_gl_DrawID",hn),Re.render(gn[hn]/ge,Ft[hn])}else if(Z.isInstancedMesh)Re.renderInstances(Bt,Ze,Z.count);else if(j.isInstancedBufferGeometry){let gn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ft=Math.min(j.instanceCount,gn);Re.renderInstances(Bt,Ze,Ft)}else Re.render(Bt,Ze)};function na(w,B,j,$){H!==null&&w.isNodeMaterial&&H.setObject($,w),Ue===!0&&it.setState(w,j,!1),w.transparent===!0&&w.side===ss&&w.forceSinglePass===!1?(w.side=Zn,w.needsUpdate=!0,Hi(w,B,$),w.side=lr,w.needsUpdate=!0,Hi(w,B,$),w.side=ss):Hi(w,B,$)}this.compile=function(w,B,j=null){j===null&&(j=w),H!==null&&H.renderStart(w,B,j),E=et.get(j),E.init(B),T.push(E),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(B.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),w!==j&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(B.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),H!==null&&H.updateLights(E.state.lightsArray),an=this.localClippingEnabled,Ue=it.init(this.clippingPlanes,an),Ue===!0&&it.setGlobalState(this.clippingPlanes,B),H!==null&&pt.render(E.state.shadowsArray,j,B);let $=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let Et=Tt[Pt];na(Et,j,B,Z),$.add(Et)}else na(Tt,j,B,Z),$.add(Tt)}),E=T.pop(),H!==null&&H.renderEnd(),$},this.compileAsync=function(w,B,j=null){let $=this.compile(w,B,j);return new Promise(Z=>{function Tt(){if($.forEach(function(Pt){let It=Ht.get(Pt).currentProgram;(It===void 0||It.isReady())&&$.delete(Pt)}),$.size===0){Z(w);return}setTimeout(Tt,10)}Yt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Hr=null;function od(w){Hr&&Hr(w)}function El(){ls.stop()}function zi(){ls.start()}let ls=new N_;ls.setAnimationLoop(od),typeof self<"u"&&ls.setContext(self),this.setAnimationLoop=function(w){Hr=w,lt.setAnimationLoop(w),w===null?ls.stop():ls.start()},lt.addEventListener("sessionstart",El),lt.addEventListener("sessionend",zi),this.render=function(w,B){if(B!==void 0&&B.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;H!==null&&H.renderStart(w,B);let j=lt.enabled===!0&&lt.isPresenting===!0,$=k!==null&&(ct===null||j)&&k.begin(F,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),lt.enabled===!0&&lt.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(lt.cameraAutoUpdate===!0&&lt.updateCamera(B),B=lt.getCamera()),w.isScene===!0&&w.onBeforeRender(F,w,B,ct),E=et.get(w,T.length),E.init(B),E.state.textureUnits=qt.getTextureUnits(),T.push(E),Pe.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?qe.setFromArrayCamera(B):ee.setFromProjectionMatrix(Pe,vi,B.reversedDepth),an=this.localClippingEnabled,Ue=it.init(this.clippingPlanes,an),C=xt.get(w,_.length),C.init(),_.push(C),this.info.render.frame++,lt.enabled===!0&&lt.isPresenting===!0){let Pt=F.xr.getDepthSensingMesh();Pt!==null&&cs(Pt,B,-1/0,F.sortObjects)}cs(w,B,0,F.sortObjects),C.finish(),H!==null&&H.updateLights(E.state.lightsArray),F.sortObjects===!0&&C.sort(Wt,ie),Qe=lt.enabled===!1||lt.isPresenting===!1||lt.hasDepthSensing()===!1,Qe&&U.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),Ue===!0&&it.beginShadows();let Z=E.state.shadowsArray;if(pt.render(Z,w,B),Ue===!0&&it.endShadows(),($&&k.hasRenderPass())===!1){let Pt=C.opaque,Et=C.transmissive;if(E.setupLights(),B.isArrayCamera){let It=B.cameras;if(Et.length>0)for(let zt=0,jt=It.length;zt<jt;zt++){let fe=It[zt];wi(Pt,Et,w,fe)}Qe&&U.render(w);for(let zt=0,jt=It.length;zt<jt;zt++){let fe=It[zt];ia(C,w,fe,fe.viewport)}}else Et.length>0&&wi(Pt,Et,w,B),Qe&&U.render(w),ia(C,w,B)}ct!==null&&G===0&&(qt.updateMultisampleRenderTarget(ct),qt.updateRenderTargetMipmap(ct)),$&&k.end(F),w.isScene===!0&&w.onAfterRender(F,w,B),bt.resetDefaultState(),K=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],qt.setTextureUnits(E.state.textureUnits),Ue===!0&&it.setGlobalState(F.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,H!==null&&H.renderEnd()};function cs(w,B,j,$){if(w.visible===!1)return;if(w.layers.test(B.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(B);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Pt=B.isArrayCamera?qe:ee;if(!w.frustumCulled||w.intersectsFrustum(Pt)){$&&xe.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Pe);let Et=ht.update(w),It=w.material;It.visible&&C.push(w,Et,It,j,xe.z,null,B)}}else if(w.isMesh||w.isLine||w.isPoints){let Pt=B.isArrayCamera?qe:ee;if(!w.frustumCulled||w.intersectsFrustum(Pt)){let Et=ht.update(w),It=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xe.copy(w.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),xe.copy(Et.boundingSphere.center)),xe.applyMatrix4(w.matrixWorld).applyMatrix4(Pe)),Array.isArray(It)){let zt=Et.groups;for(let jt=0,fe=zt.length;jt<fe;jt++){let Bt=zt[jt],pe=It[Bt.materialIndex];pe&&pe.visible&&C.push(w,Et,pe,j,xe.z,Bt,B)}}else It.visible&&C.push(w,Et,It,j,xe.z,null,B)}}}let Tt=w.children;for(let Pt=0,Et=Tt.length;Pt<Et;Pt++)cs(Tt[Pt],B,j,$)}function ia(w,B,j,$){let{opaque:Z,transmissive:Tt,transparent:Pt}=w;E.setupLightsView(j),Ue===!0&&it.setGlobalState(F.clippingPlanes,j),$&&Mt.viewport(st.copy($)),Z.length>0&&tn(Z,B,j),Tt.length>0&&tn(Tt,B,j),Pt.length>0&&tn(Pt,B,j),Mt.buffers.depth.setTest(!0),Mt.buffers.depth.setMask(!0),Mt.buffers.color.setMask(!0),Mt.setPolygonOffset(!1)}function wi(w,B,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[$.id]===void 0){let Bt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[$.id]=new di(1,1,{generateMipmaps:!0,type:Bt?ki:jn,minFilter:Is,samples:Math.max(4,se.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Tt=E.state.transmissionRenderTarget[$.id],Pt=$.viewport||st;Tt.setSize(Pt.z*F.transmissionResolutionScale,Pt.w*F.transmissionResolutionScale);let Et=F.getRenderTarget(),It=F.getActiveCubeFace(),zt=F.getActiveMipmapLevel();F.setRenderTarget(Tt),F.getClearColor(tt),mt=F.getClearAlpha(),mt<1&&F.setClearColor(16777215,.5),F.clear(),Qe&&U.render(j);let jt=F.toneMapping;F.toneMapping=rs;let fe=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),E.setupLightsView($),Ue===!0&&it.setGlobalState(F.clippingPlanes,$),tn(w,j,$),qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let pe=0,Ze=B.length;pe<Ze;pe++){let Ae=B[pe],{object:Re,geometry:gn,material:Ft,group:cn}=Ae;if(Ft.side===ss&&Re.layers.test($.layers)){let ge=Ft.side;Ft.side=Zn,Ft.needsUpdate=!0,rn(Re,j,$,gn,Ft,cn),Ft.side=ge,Ft.needsUpdate=!0,Bt=!0}}Bt===!0&&(qt.updateMultisampleRenderTarget(Tt),qt.updateRenderTargetMipmap(Tt))}F.setRenderTarget(Et,It,zt),F.setClearColor(tt,mt),fe!==void 0&&($.viewport=fe),F.toneMapping=jt}function tn(w,B,j){let $=B.isScene===!0?B.overrideMaterial:null;for(let Z=0,Tt=w.length;Z<Tt;Z++){let Pt=w[Z],{object:Et,geometry:It,group:zt}=Pt,jt=Pt.material;jt.allowOverride===!0&&$!==null&&(jt=$),Et.layers.test(j.layers)&&rn(Et,B,j,It,jt,zt)}}function rn(w,B,j,$,Z,Tt){H!==null&&Z.isNodeMaterial&&H.setObject(w,Z),w.onBeforeRender(F,B,j,$,Z,Tt),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(F,B,j,$,w,Tt),Z.transparent===!0&&Z.side===ss&&Z.forceSinglePass===!1?(Z.side=Zn,Z.needsUpdate=!0,F.renderBufferDirect(j,B,$,Z,w,Tt),Z.side=lr,Z.needsUpdate=!0,F.renderBufferDirect(j,B,$,Z,w,Tt),Z.side=ss):F.renderBufferDirect(j,B,$,Z,w,Tt),w.onAfterRender(F,B,j,$,Z,Tt)}function on(w){let B=0;for(let j of w)j.texture!==null&&B++;return B}function Hi(w,B,j){B.isScene!==!0&&(B=mn);let $=Ht.get(w),Z=E.state.lights,Tt=E.state.shadowsArray,Pt=Z.state.version,Et=ot.getParameters(w,Z.state,Tt,B,j,E.state.lightProbeGridArray),It=ot.getProgramCacheKey(Et),zt=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?B.environment:null,$.fog=B.fog;let jt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=R.get(w.envMap||$.environment,jt),$.envMapRotation=$.environment!==null&&w.envMap===null?B.environmentRotation:w.envMapRotation,zt===void 0&&(w.addEventListener("dispose",re),zt=new Map,$.programs=zt,$.programVariants=new Map);let fe=zt.get(It);if(fe!==void 0){if($.currentProgram===fe&&$.lightsStateVersion===Pt)return sa(w,Et),fe}else Et.uniforms=ot.getUniforms(w),H!==null&&w.isNodeMaterial&&H.build(w,j,Et),w.onBeforeCompile(Et,F),fe=ot.acquireProgram(Et,It),zt.set(It,fe),$.uniforms=Et.uniforms;let Bt=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Bt.clippingPlanes=it.uniform),sa(w,Et),$.needsLights=Fs(w),$.lightsStateVersion=Pt,$.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=on(E.state.lightProbeGridArray),$.currentProgram=fe,$.uniformsList=null,fe}function ti(w,B,j,$,Z){let Tt=Ht.get(w),Pt=Tt.currentProgram.id+","+$+","+Z,Et=Tt.programVariants.get(Pt);return Et===void 0?(Et=Hi(w,B,j),Tt.programVariants.set(Pt,Et)):(Tt.currentProgram=Et,Tt.uniformsList=null,Tt.outputColorSpace=$,Tt.toneMapping=Z),Et}function Ns(w){if(w.uniformsList===null){let B=w.currentProgram.getUniforms();w.uniformsList=jo.seqWithValue(B.seq,w.uniforms)}return w.uniformsList}function sa(w,B){let j=Ht.get(w);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function ra(w,B,j,$,Z){B.isScene!==!0&&(B=mn),qt.resetTextureUnits();let Tt=B.fog,Pt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?B.environment:null,Et=ct===null?F.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:_e.workingColorSpace,It=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,zt=R.get($.envMap||Pt,It),jt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,fe=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Bt=!!j.morphAttributes.position,pe=!!j.morphAttributes.normal,Ze=!!j.morphAttributes.color,Ae=rs;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Ae=F.toneMapping);let Re=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,gn=Re!==void 0?Re.length:0,Ft=Ht.get($),cn=E.state.lights;if(Ue===!0&&(an===!0||w!==Q)){let Ce=w===Q&&$.id===K;it.setState($,w,Ce)}let ge=!1,hs=!1;$.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==cn.state.version||Z.isBatchedMesh&&Ft.batching===!1||!Z.isBatchedMesh&&Ft.batching===!0||Z.isBatchedMesh&&Ft.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ft.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ft.instancing===!1||!Z.isInstancedMesh&&Ft.instancing===!0||Z.isSkinnedMesh&&Ft.skinning===!1||!Z.isSkinnedMesh&&Ft.skinning===!0||Z.isInstancedMesh&&Ft.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ft.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ft.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ft.instancingMorph===!1&&Z.morphTexture!==null||Ft.envMap!==zt||$.fog===!0&&Ft.fog!==Tt||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==it.numPlanes||Ft.numIntersection!==it.numIntersection)||Ft.vertexAlphas!==jt||Ft.vertexTangents!==fe||Ft.morphTargets!==Bt||Ft.morphNormals!==pe||Ft.morphColors!==Ze||Ft.morphTargetsCount!==gn||Ft.numLightProbeGrids!==on(E.state.lightProbeGridArray)?ge=!0:(Ft.outputColorSpace!==Et||Ft.toneMapping!==Ae)&&(hs=!0):(ge=!0,Ft.__version=$.version);let hn=Ft.currentProgram;(ge===!0||hs===!0)&&(hn=hs===!0?ti($,B,Z,Et,Ae):Hi($,B,Z),H&&$.isNodeMaterial&&H.onUpdateProgram($,hn,Ft));let Wr=!1,Vi=!1,us=!1,ae=hn.getUniforms(),en=Ft.uniforms;if(Mt.useProgram(hn.program)&&(Wr=!0,Vi=!0,us=!0),$.id!==K&&(K=$.id,Vi=!0),Wr||Q!==w){Mt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),ae.setValue(O,"projectionMatrix",w.projectionMatrix),ae.setValue(O,"viewMatrix",w.matrixWorldInverse);let un=ae.map.cameraPosition;un!==void 0&&un.setValue(O,Mn.setFromMatrixPosition(w.matrixWorld)),se.logarithmicDepthBuffer&&ae.setValue(O,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ae.setValue(O,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,Vi=!0,us=!0)}if(Ft.needsLights&&(cn.state.sunShadowMap.length>0&&ae.setValue(O,"sunShadowMap",cn.state.sunShadowMap,qt),cn.state.directionalShadowMap.length>0&&ae.setValue(O,"directionalShadowMap",cn.state.directionalShadowMap,qt),cn.state.spotShadowMap.length>0&&ae.setValue(O,"spotShadowMap",cn.state.spotShadowMap,qt),cn.state.pointShadowMap.length>0&&ae.setValue(O,"pointShadowMap",cn.state.pointShadowMap,qt)),Z.isSkinnedMesh){ae.setOptional(O,Z,"bindMatrix"),ae.setOptional(O,Z,"bindMatrixInverse");let Ce=Z.skeleton;Ce&&(Ce.boneTexture===null&&Ce.computeBoneTexture(),ae.setValue(O,"boneTexture",Ce.boneTexture,qt))}Z.isBatchedMesh&&(ae.setOptional(O,Z,"batchingTexture"),ae.setValue(O,"batchingTexture",Z._matricesTexture,qt),ae.setOptional(O,Z,"batchingIdTexture"),ae.setValue(O,"batchingIdTexture",Z._indirectTexture,qt),ae.setOptional(O,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ae.setValue(O,"batchingColorTexture",Z._colorsTexture,qt));let Hn=j.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&rt.update(Z,j,hn),(Vi||Ft.receiveShadow!==Z.receiveShadow)&&(Ft.receiveShadow=Z.receiveShadow,ae.setValue(O,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&B.environment!==null&&(en.envMapIntensity.value=B.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=wA()),Vi){if(ae.setValue(O,"toneMappingExposure",F.toneMappingExposure),Ft.needsLights&&Vr(en,us),Tt&&$.fog===!0&&yt.refreshFogUniforms(en,Tt),yt.refreshMaterialUniforms(en,$,St,At,E.state.transmissionRenderTarget[w.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Ce=S,un=0;for(let Fn of E.state.lightProbeGridArray)Fn.texture!==null&&(Ce.textures[un]=Fn.texture,Ce.min[un]=Fn.boundingBox.min,Ce.max[un]=Fn.boundingBox.max,Ce.resolution[un]=Fn.resolution,un++);for(let Fn in Ce)Ce[Fn].length=un;en.probesSH.value=Ce.textures,en.probesMin.value=Ce.min,en.probesMax.value=Ce.max,en.probesResolution.value=Ce.resolution}jo.upload(O,Ns(Ft),en,qt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(jo.upload(O,Ns(Ft),en,qt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ae.setValue(O,"center",Z.center),ae.setValue(O,"modelViewMatrix",Z.modelViewMatrix),ae.setValue(O,"normalMatrix",Z.normalMatrix),ae.setValue(O,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Ce=$.uniformsGroups;for(let un=0,Fn=Ce.length;un<Fn;un++){let Al=Ce[un];Gt.update(Al,hn),Gt.bind(Al,hn)}}return hn}function Vr(w,B){w.ambientLightColor.needsUpdate=B,w.lightProbe.needsUpdate=B,w.sunLights.needsUpdate=B,w.sunLightShadows.needsUpdate=B,w.directionalLights.needsUpdate=B,w.directionalLightShadows.needsUpdate=B,w.pointLights.needsUpdate=B,w.pointLightShadows.needsUpdate=B,w.spotLights.needsUpdate=B,w.spotLightShadows.needsUpdate=B,w.rectAreaLights.needsUpdate=B,w.hemisphereLights.needsUpdate=B}function Fs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,B,j){let $=Ht.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ht.get(w.texture).__webglTexture=B,Ht.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,B){let j=Ht.get(w);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(w,B=0,j=0){ct=w,Y=B,G=j;let $=null,Z=!1,Tt=!1;if(w){let Et=Ht.get(w);if(Et.__useDefaultFramebuffer!==void 0){Mt.bindFramebuffer(O.FRAMEBUFFER,Et.__webglFramebuffer),st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest,Mt.viewport(st),Mt.scissor(dt),Mt.setScissorTest(ut),K=-1;return}else if(Et.__webglFramebuffer===void 0)qt.setupRenderTarget(w);else if(Et.__hasExternalTextures)qt.rebindTextures(w,Ht.get(w.texture).__webglTexture,Ht.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let jt=w.depthTexture;if(Et.__boundDepthTexture!==jt){if(jt!==null&&Ht.has(jt)&&(w.width!==jt.image.width||w.height!==jt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(w)}}let It=w.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Tt=!0);let zt=Ht.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(zt[B])?$=zt[B][j]:$=zt[B],Z=!0):w.samples>0&&qt.useMultisampledRTT(w)===!1?$=Ht.get(w).__webglMultisampledFramebuffer:Array.isArray(zt)?$=zt[j]:$=zt,st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest}else st.copy(Vt).multiplyScalar(St).floor(),dt.copy(de).multiplyScalar(St).floor(),ut=oe;if(j!==0&&($=W),Mt.bindFramebuffer(O.FRAMEBUFFER,$)&&Mt.drawBuffers(w,$),Mt.viewport(st),Mt.scissor(dt),Mt.setScissorTest(ut),Z){let Et=Ht.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+B,Et.__webglTexture,j)}else if(Tt){let Et=B;for(let It=0;It<w.textures.length;It++){let zt=Ht.get(w.textures[It]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+It,zt.__webglTexture,j,Et)}}else if(w!==null&&j!==0){let Et=Ht.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Et.__webglTexture,j)}K=-1};function Gr(w){let B=Ht.get(w);return(B.__readFormat!==w.format||B.__readType!==w.type)&&(B.__readFormat=w.format,B.__readType=w.type,B.__formatReadable=se.textureFormatReadable(w.format),B.__typeReadable=se.textureTypeReadable(w.type)),B}this.readRenderTargetPixels=function(w,B,j,$,Z,Tt,Pt,Et=0){if(!(w&&w.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=Ht.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){Mt.bindFramebuffer(O.FRAMEBUFFER,It);try{let zt=w.textures[Et],jt=zt.format,fe=zt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Et);let Bt=Gr(zt);if(Bt.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=w.width-$&&j>=0&&j<=w.height-Z&&O.readPixels(B,j,$,Z,gt.convert(jt),gt.convert(fe),Tt)}finally{let zt=ct!==null?Ht.get(ct).__webglFramebuffer:null;Mt.bindFramebuffer(O.FRAMEBUFFER,zt)}}},this.readRenderTargetPixelsAsync=async function(w,B,j,$,Z,Tt,Pt,Et=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=Ht.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(B>=0&&B<=w.width-$&&j>=0&&j<=w.height-Z){Mt.bindFramebuffer(O.FRAMEBUFFER,It);let zt=w.textures[Et],jt=zt.format,fe=zt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Et);let Bt=Gr(zt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pe),O.bufferData(O.PIXEL_PACK_BUFFER,Tt.byteLength,O.STREAM_READ),O.readPixels(B,j,$,Z,gt.convert(jt),gt.convert(fe),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Ze=ct!==null?Ht.get(ct).__webglFramebuffer:null;Mt.bindFramebuffer(O.FRAMEBUFFER,Ze);let Ae=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await r_(O,Ae,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pe),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Tt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pe),O.deleteSync(Ae),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,B=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(w.image.width*$),Tt=Math.floor(w.image.height*$),Pt=B!==null?B.x:0,Et=B!==null?B.y:0;qt.setTexture2D(w,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Pt,Et,Z,Tt),Mt.unbindTexture()},this.copyTextureToTexture=function(w,B,j=null,$=null,Z=0,Tt=0){let Pt,Et,It,zt,jt,fe,Bt,pe,Ze,Ae=w.isCompressedTexture?w.mipmaps[Tt]:w.image;if(j!==null)Pt=j.max.x-j.min.x,Et=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,zt=j.min.x,jt=j.min.y,fe=j.isBox3?j.min.z:0;else{let ae=Math.pow(2,-Z);Pt=Math.floor(Ae.width*ae),Et=Math.floor(Ae.height*ae),w.isDataArrayTexture?It=Ae.depth:w.isData3DTexture?It=Math.floor(Ae.depth*ae):It=1,zt=0,jt=0,fe=0}$!==null?(Bt=$.x,pe=$.y,Ze=$.z):(Bt=0,pe=0,Ze=0);let Re=gt.convert(B.format),gn=gt.convert(B.type),Ft;B.isData3DTexture?(qt.setTexture3D(B,0),Ft=O.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(qt.setTexture2DArray(B,0),Ft=O.TEXTURE_2D_ARRAY):(qt.setTexture2D(B,0),Ft=O.TEXTURE_2D),Mt.activeTexture(O.TEXTURE0),Mt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,B.flipY),Mt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Mt.pixelStorei(O.UNPACK_ALIGNMENT,B.unpackAlignment);let cn=Mt.getParameter(O.UNPACK_ROW_LENGTH),ge=Mt.getParameter(O.UNPACK_IMAGE_HEIGHT),hs=Mt.getParameter(O.UNPACK_SKIP_PIXELS),hn=Mt.getParameter(O.UNPACK_SKIP_ROWS),Wr=Mt.getParameter(O.UNPACK_SKIP_IMAGES);Mt.pixelStorei(O.UNPACK_ROW_LENGTH,Ae.width),Mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Ae.height),Mt.pixelStorei(O.UNPACK_SKIP_PIXELS,zt),Mt.pixelStorei(O.UNPACK_SKIP_ROWS,jt),Mt.pixelStorei(O.UNPACK_SKIP_IMAGES,fe);let Vi=w.isDataArrayTexture||w.isData3DTexture,us=B.isDataArrayTexture||B.isData3DTexture;if(w.isDepthTexture){let ae=Ht.get(w),en=Ht.get(B),Hn=Ht.get(ae.__renderTarget),Ce=Ht.get(en.__renderTarget);Mt.bindFramebuffer(O.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ce.__webglFramebuffer);for(let un=0;un<It;un++)Vi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ht.get(w).__webglTexture,Z,fe+un),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ht.get(B).__webglTexture,Tt,Ze+un)),O.blitFramebuffer(zt,jt,zt+Pt,jt+Et,Bt,pe,Bt+Pt,pe+Et,O.DEPTH_BUFFER_BIT,O.NEAREST);Mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Ht.has(w)){let ae=Ht.get(w),en=Ht.get(B);Mt.bindFramebuffer(O.READ_FRAMEBUFFER,L),Mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,X);for(let Hn=0;Hn<It;Hn++)Vi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ae.__webglTexture,Z,fe+Hn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ae.__webglTexture,Z),us?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,en.__webglTexture,Tt,Ze+Hn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,en.__webglTexture,Tt),Z!==0?O.blitFramebuffer(zt,jt,zt+Pt,jt+Et,Bt,pe,Bt+Pt,pe+Et,O.COLOR_BUFFER_BIT,O.NEAREST):us?O.copyTexSubImage3D(Ft,Tt,Bt,pe,Ze+Hn,zt,jt,Pt,Et):O.copyTexSubImage2D(Ft,Tt,Bt,pe,zt,jt,Pt,Et);Mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else us?w.isDataTexture||w.isData3DTexture?O.texSubImage3D(Ft,Tt,Bt,pe,Ze,Pt,Et,It,Re,gn,Ae.data):B.isCompressedArrayTexture?O.compressedTexSubImage3D(Ft,Tt,Bt,pe,Ze,Pt,Et,It,Re,Ae.data):O.texSubImage3D(Ft,Tt,Bt,pe,Ze,Pt,Et,It,Re,gn,Ae):w.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Tt,Bt,pe,Pt,Et,Re,gn,Ae.data):w.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Tt,Bt,pe,Ae.width,Ae.height,Re,Ae.data):O.texSubImage2D(O.TEXTURE_2D,Tt,Bt,pe,Pt,Et,Re,gn,Ae);Mt.pixelStorei(O.UNPACK_ROW_LENGTH,cn),Mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,ge),Mt.pixelStorei(O.UNPACK_SKIP_PIXELS,hs),Mt.pixelStorei(O.UNPACK_SKIP_ROWS,hn),Mt.pixelStorei(O.UNPACK_SKIP_IMAGES,Wr),Tt===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&O.generateMipmap(Ft),Mt.unbindTexture()},this.initRenderTarget=function(w){Ht.get(w).__webglFramebuffer===void 0&&qt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?qt.setTextureCube(w,0):w.isData3DTexture?qt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?qt.setTexture2DArray(w,0):qt.setTexture2D(w,0),Mt.unbindTexture()},this.resetState=function(){Y=0,G=0,ct=null,Mt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};var X_={type:"change"},zp={type:"start"},$_={type:"end"},Uu=new Dr,q_=new hi,TA=Math.cos(70*Mp.DEG2RAD),Sn=new z,Qn=2*Math.PI,we={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Bp=1e-6,Ou=class extends ul{constructor(t,e=null){super(t,e),this.state=we.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:or.ROTATE,MIDDLE:or.DOLLY,RIGHT:or.PAN},this.touches={ONE:ar.ROTATE,TWO:ar.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new ui,this._lastTargetPosition=new z,this._quat=new ui().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new qo,this._sphericalDelta=new qo,this._scale=1,this._panOffset=new z,this._rotateStart=new Ot,this._rotateEnd=new Ot,this._rotateDelta=new Ot,this._panStart=new Ot,this._panEnd=new Ot,this._panDelta=new Ot,this._dollyStart=new Ot,this._dollyEnd=new Ot,this._dollyDelta=new Ot,this._dollyDirection=new z,this._mouse=new Ot,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=AA.bind(this),this._onPointerDown=EA.bind(this),this._onPointerUp=RA.bind(this),this._onContextMenu=FA.bind(this),this._onMouseWheel=IA.bind(this),this._onKeyDown=LA.bind(this),this._onTouchStart=DA.bind(this),this._onTouchMove=NA.bind(this),this._onMouseDown=CA.bind(this),this._onMouseMove=PA.bind(this),this._interceptControlDown=UA.bind(this),this._interceptControlUp=OA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=we.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(X_),this.update(),this.state=we.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===we.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Qn:n>Math.PI&&(n-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Uu.origin.copy(this.object.position),Uu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Uu.direction))<TA?this.object.lookAt(this.target):(q_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Uu.intersectPlane(q_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Bp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Bp||this._lastTargetPosition.distanceToSquared(this.target)>Bp?(this.dispatchEvent(X_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Qn/60*this.autoRotateSpeed*t:Qn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Ot,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function EA(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function AA(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function RA(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($_),this.state=we.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function CA(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case or.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=we.DOLLY;break;case or.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=we.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=we.ROTATE}break;case or.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=we.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=we.PAN}break;default:this.state=we.NONE}this.state!==we.NONE&&this.dispatchEvent(zp)}function PA(i){switch(this.state){case we.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case we.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case we.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function IA(i){this.enabled===!1||this.enableZoom===!1||this.state!==we.NONE||(i.preventDefault(),this.dispatchEvent(zp),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent($_))}function LA(i){this.enabled!==!1&&this._handleKeyDown(i)}function DA(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case ar.ROTATE:if(this.enableRotate===!1){this.state=we.NONE;break}this._handleTouchStartRotate(i),this.state=we.TOUCH_ROTATE;break;case ar.PAN:if(this.enablePan===!1){this.state=we.NONE;break}this._handleTouchStartPan(i),this.state=we.TOUCH_PAN;break;default:this.state=we.NONE}break;case 2:switch(this.touches.TWO){case ar.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=we.TOUCH_DOLLY_PAN;break;case ar.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=we.TOUCH_DOLLY_ROTATE;break;default:this.state=we.NONE}break;default:this.state=we.NONE}this.state!==we.NONE&&this.dispatchEvent(zp)}function NA(i){switch(this._trackPointer(i),this.state){case we.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case we.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case we.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case we.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=we.NONE}}function FA(i){this.enabled!==!1&&i.preventDefault()}function UA(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function OA(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Hp=new z(.51*10,0,0),Y_=new z(.2,.24,1).normalize(),[kA,BA]=[1.34*10,.74*10],ku=class{camera=new $n(24,2,1,200);#t;constructor(t,e){this.#t=new Ou(this.camera,t),this.#t.enablePan=!1,this.#t.enableZoom=!1,this.#t.minPolarAngle=.25*Math.PI,this.#t.maxPolarAngle=.56*Math.PI,this.#t.minAzimuthAngle=-.35*Math.PI,this.#t.maxAzimuthAngle=.35*Math.PI,this.#t.target.copy(Hp),this.#t.addEventListener("change",e),t.style.touchAction="pan-y"}fit(t){this.camera.aspect=t,this.camera.updateProjectionMatrix();let e=this.camera.position.clone().sub(Hp);(e.lengthSq()<1e-6||this.camera.position.lengthSq()<1e-6)&&e.copy(Y_),this.#e(e.normalize())}reset(){this.#e(Y_)}#e(t){let e=Math.tan(this.camera.fov*Math.PI/360),n=Math.max(BA,kA/this.camera.aspect)/(2*e);this.camera.position.copy(Hp).addScaledVector(t,n),this.#t.update()}};var Bu=class{root=N("div",{class:"hud"});#t=N("p",{class:"hud-name"});#e=N("p",{class:"hud-trial"});#n=N("p",{class:"hud-time"});#i=N("p",{class:"hud-note"});#s=N("table",{class:"hud-ports"});#a=[];#o=null;#r=-1;#l=[];#c=[];constructor(){this.root.append(this.#t,N("div",{},this.#e,this.#n,this.#i),this.#s)}name(t){le(this.#t,t),this.#t.title=t}show({run:t,trial:e,time:n},s){this.#o!==t&&this.#h(t),this.#r!==e&&this.#u(t,e),le(this.#e,`Trial ${e} of ${t.picture.trials}`),le(this.#n,`t = ${n.toFixed(t.picture.duration<.1?5:3)} s`),le(this.#i,s);let r=t.trial(e);this.#a.forEach((o,a)=>{le(o.motion,r?this.#l[a].text(r.at("y",a,n)):"…"),le(o.effort,r?this.#c[a].text(r.at("delivered",a,n)):"…")})}#h(t){this.#o=t,this.#r=-1,this.#a=t.ports.map(()=>({motion:N("td",{}),effort:N("td",{})})),this.#s.replaceChildren(N("caption",{class:"unseen"},"Motion and delivered effort at the moment"),N("tbody",{},...t.ports.map((e,n)=>this.#d(t,e,n))))}#u(t,e){this.#r=e,this.#l=t.ports.map((n,s)=>new Je(t.largest("y",s,e),n.motion_unit)),this.#c=t.ports.map((n,s)=>new Je(t.largest("delivered",s,e),n.effort_unit))}#d(t,e,n){let{motion:s,effort:r}=this.#a[n],o=N("span",{class:"key"});return o.style.background=`var(--${Yi(t.ports,n).token})`,N("tr",{},N("th",{scope:"row"},o,va(e)),s,N("th",{scope:"row"},vr(e)),r)}};function zu(i){return`deflection × ${Ri(i,i<10?2:3).replace(/\.0+$/,"")}`}var[Gp,J_,wl]=[.055,.16,.34],K_=.02,Hu=class i{static LONGEST=1.9;group=new Ke;#t;#e;#n;constructor(t,e){this.#n=t,this.#t=new Xe(new nr(Gp,Gp,1,12).translate(0,.5,0),e),this.#e=new Xe(new Vo(J_,wl,16).translate(0,wl/2,0),e),this.group.add(this.#t,this.#e)}take(t,e,n){let s=Math.abs(n);if(this.group.visible=s>K_,!this.group.visible)return;let r=n>0?1:-1,o=s*i.LONGEST,a=Math.min(1,o/wl),l=o-a*wl;this.group.position.set(t,e+r*this.#n,0),this.group.rotation.z=r>0?0:Math.PI,this.#t.visible=l>0,this.#t.scale.set(a,Math.max(l,.001),a),this.#e.position.y=l,this.#e.scale.setScalar(a)}},[Vu,j_,Q_,Vp,Z_]=[.82,5/6*Math.PI,1.4*Math.PI,60,8],zA=new Go(Array.from({length:37},(i,t)=>{let e=j_+t/36*Q_;return new z(Vu*Math.cos(e),Vu*Math.sin(e),0)})),Gu=class{group=new Ke;#t;#e;constructor(t){this.#t=new sl(zA,Vp,Gp,Z_),this.#e=new Xe(new Vo(J_,wl,16),t),this.group.add(new Xe(this.#t,t),this.#e),this.group.position.z=Jn/2+.2}take(t,e,n){let s=Math.abs(n);if(this.group.visible=s>K_,!this.group.visible)return;let r=Math.max(1,Math.round(s*Vp));this.#t.setDrawRange(0,r*Z_*6);let o=j_+r/Vp*Q_;this.#e.position.set(Vu*Math.cos(o),Vu*Math.sin(o),0),this.#e.rotation.z=o,this.#e.scale.setScalar(Math.min(1,.4+2*s)),this.group.position.x=t,this.group.position.y=e,this.group.rotation.y=n>0?0:Math.PI}};var Wu=Hs/2,zr=Jn/2,Xu=[{edges:[[1,1],[1,-1]],turned:1,out:0},{edges:[[-1,-1],[-1,1]],turned:-1,out:0},{edges:[[-1,1],[1,1]],turned:0,out:1},{edges:[[1,-1],[-1,-1]],turned:0,out:-1}],tx=.03,qu=class{group=new Ke;#t;#e;#n=new je;#i=new je;#s=new je;constructor(t,e){this.#t=t.x.length,this.#e=Math.max(1,Math.round(this.#t/26));let n=this.#t*2;this.#n.setAttribute("position",hr(Xu.length*n)),this.#n.setAttribute("normal",hr(Xu.length*n)),this.#n.setIndex(Xu.flatMap((s,r)=>ex(this.#t,r*n))),this.#i.setAttribute("position",hr(4*Math.ceil(this.#t/this.#e))),this.#s.setAttribute("position",hr(n)),this.#s.setIndex(ex(this.#t,0)),this.group.add(new Xe(this.#n,e.body),new es(this.#i,e.section),new Xe(this.#s,e.centre));for(let s of this.group.children)s.frustumCulled=!1}take({x:t,y:e,angle:n}){let s=this.#n.getAttribute("position"),r=this.#n.getAttribute("normal"),o=this.#i.getAttribute("position"),a=this.#s.getAttribute("position"),l=0;for(let{edges:c,turned:h,out:u}of Xu)for(let d=0;d<this.#t;d++){let[f,p]=[Math.sin(n[d]),Math.cos(n[d])];for(let[x,m]of c)s.setXYZ(l,t[d]-x*Wu*f,e[d]+x*Wu*p,m*zr),r.setXYZ(l++,-h*f,h*p,u)}for(let c=0,h=0;c<this.#t;c+=this.#e,h+=4){let[u,d]=[Wu*Math.sin(n[c]),Wu*Math.cos(n[c])];o.setXYZ(h,t[c]+u,e[c]-d,zr),o.setXYZ(h+1,t[c]-u,e[c]+d,zr),o.setXYZ(h+2,t[c]-u,e[c]+d,zr),o.setXYZ(h+3,t[c]-u,e[c]+d,-zr)}for(let c=0;c<this.#t;c++){let[h,u]=[tx*Math.sin(n[c]),tx*Math.cos(n[c])];a.setXYZ(2*c,t[c]+h,e[c]-u,zr+.01),a.setXYZ(2*c+1,t[c]-h,e[c]+u,zr+.01)}for(let c of[s,r,o,a])c.needsUpdate=!0}};function hr(i){return new bi(new Float32Array(3*i),3).setUsage(yp)}function ex(i,t){let e=[];for(let n=0;n<i-1;n++){let[s,r]=[t+2*n,t+2*n+1];e.push(s,s+2,r+2,s,r+2,r)}return e}var $u=class{line;#t=new je;constructor(t,e){this.#t.setAttribute("position",hr(2*t.x.length)),this.line=new Ja(this.#t,e.ghost),this.line.frustumCulled=!1,this.line.renderOrder=1}take({x:t,y:e,angle:n}){let s=this.#t.getAttribute("position"),r=t.length;for(let o=0;o<r;o++){let[a,l]=[Hs/2*Math.sin(n[o]),Hs/2*Math.cos(n[o])];s.setXYZ(o,t[o]-a,e[o]+l,Jn/2),s.setXYZ(2*r-1-o,t[o]+a,e[o]-l,Jn/2)}s.needsUpdate=!0}dispose(){this.#t.dispose()}};var Tl=class{x;y;angle;turns;bends;#t;#e;#n;#i;constructor(t,e){let{fields:n,span:s}=t.picture,r=10/s;this.#n=e,this.#i=e/r,this.#t=n.find(({unit:o})=>o==="m")?.name??null,this.#e=n.find(({unit:o})=>o==="rad")?.name??null,this.bends=this.#t!==null&&t.x.length>1,this.turns=this.bends&&this.#e!==null,this.x=this.bends?t.x.map(o=>o*r):Float32Array.of(0,10),this.y=new Float32Array(this.x.length),this.angle=new Float32Array(this.x.length)}take(t,e,n){if(!this.#t||!this.bends)return;let{x:s,y:r,angle:o}=this;t.shape(this.#t,e,r);for(let l=0;l<r.length;l++)r[l]*=n*this.#n;if(this.#e){t.shape(this.#e,e,o);for(let l=0;l<o.length;l++)o[l]=Math.atan(n*this.#i*o[l]);return}let a=r.length-1;for(let l=0;l<=a;l++){let[c,h]=[l>0?l-1:0,l<a?l+1:a];o[l]=Math.atan((r[h]-r[c])/(s[h]-s[c]))}}heightAt(t){return this.#s(this.y,t)}angleAt(t){return this.#s(this.angle,t)}#s(t,e){let{x:n}=this,s=1;for(;s<n.length-1&&n[s]<e;)s++;let r=n[s-1],o=Math.min(Math.max((e-r)/(n[s]-r),0),1);return t[s-1]*(1-o)+t[s]*o}};function nx(i,t){let e=new Ke;return e.add(new Xe(i,t.block),new es(new Nr(i,30),t.edge)),e}function Wp(i,t,e,n){return nx(new ns(i,t,e),n)}function HA(i,t,e){let n=nx(new nr(i,i,t,40).rotateX(Math.PI/2),e),s=t/2+.01,r=[0,1,2,3].flatMap(o=>{let[a,l]=[Math.cos(o*Math.PI/2),Math.sin(o*Math.PI/2)];return[.25*i*a,.25*i*l,s,.85*i*a,.85*i*l,s]});return n.add(ur(r,e.edge)),n}function ur(i,t){return new es(new je().setAttribute("position",new ke(i,3)),t)}function Xp(i,t,e,n,s,r){let o=[];for(let a=r-n;a<e;a+=r){let[l,c]=[Math.max(a,0),Math.min(a+n,e)];c>l&&o.push(i+l,t+l-a,s,i+c,t+c-a,s)}return o}function ix(i,t){let e=new Ke;if(i==="clamped"){let[n,s,r]=[.8,2.2,1.35*Jn],o=Wp(n,s,r,t);o.position.x=-n/2,e.add(o,ur(Xp(-n,-s/2,n,s,r/2+.01,.24),t.faint))}else i==="pinned"&&e.add(HA(.62,1.15*Jn,t));return e}var VA=3.6,[qp,Yu,sx]=[2.6,.09,1.5*Jn],Zu=class{group=new Ke;#t;#e;#n;#i=!1;constructor(t,e,n){this.#n=e,this.#t=ox(-1,n),this.#e=ox(1,n),this.group.add(this.#t,this.#e),this.group.position.x=t}get limited(){return this.#i}get seen(){return[this.#t,this.#e].some(({visible:t,position:e})=>t&&Math.abs(e.y)<VA)}take(t,e){this.#i=Number.isFinite(t)||Number.isFinite(e),rx(this.#t,t-this.#n),rx(this.#e,e+this.#n)}};function rx(i,t){i.visible=Math.abs(t)<40,i.visible&&(i.position.y=t)}function ox(i,t){let e=new Ke,n=new ns(qp,Yu,sx).translate(0,i*Yu/2,0),s=Xp(-qp/2,i>0?Yu:-Yu-.24,qp,.24,sx/2,.2);return e.add(new Xe(n,t.wall),new es(new Nr(n),t.limit),ur(s,t.limit)),e}var[ax,lx,ta]=[.95,1.55,33],Ju=class{group=new Ke;#t=new je;#e;#n=new Ke;constructor(t){this.#t.setAttribute("position",hr(ta+2)),this.#e=new Cs(this.#t,t.limit),this.#e.frustumCulled=!1,this.#n.add(ur([.3,0,0,lx-.08,0,0],t.needle)),this.group.add(this.#e,this.#n),this.group.position.z=Jn/2+.1}take(t,e,n,s,r){this.group.position.x=t,this.group.position.y=e,this.#n.rotation.z=Math.atan(r);let[o,a]=[Number.isFinite(n),Number.isFinite(s)];this.#e.visible=o||a,this.#t.setDrawRange(o?0:ta,o&&a?ta+2:2);let[l,c]=[Math.atan(n),Math.atan(s)],h=this.#t.getAttribute("position"),u=(d,f,p)=>h.setXYZ(d,f*Math.cos(p),f*Math.sin(p),0);u(0,ax,l);for(let d=0;d<ta;d++)u(d+1,lx,l+d/(ta-1)*(c-l));u(ta+1,ax,c),h.needsUpdate=!0}};function cx(i){let{ports:t,fields:e,span:n,tip:s,clamped:r}=i.picture,o=t.map((a,l)=>$p(i,l));return JSON.stringify([t,e,n,s,r,o,[...i.x]])}var Ku=class{group=new Ke;shape;#t;#e;#n;#i;#s;#a;#o=null;constructor(t,e){let{ports:n,span:s,tip:r,clamped:o}=t.picture;this.#a=e,this.#s=10/s,this.shape=new Tl(t,this.#s),this.#t=this.shape.bends?new qu(this.shape,e):null,this.#e=ix(o,e);let a=Hs*Math.min(3,1.25+.65*Math.cbrt(r.mass));this.#n=r.mass>0?Wp(a,a,1.7*a,e):null,this.#i=n.map((h,u)=>{let d=h.x*this.#s,f=(this.#n&&h.x>.99*s?a:Hs)/2,p=h.motion_unit==="rad";return{port:h,index:u,x:d,carrier:n.findIndex(x=>x.motion_unit==="m"&&x.x===h.x),arrow:h.kind==="force"?new Hu(f,p?e.rotation:e.displacement):new Gu(e.rotation),walls:p||!$p(t,u)?null:new Zu(d,f,e),wedge:p&&$p(t,u)?new Ju(e):null,dot:this.shape.bends?null:new Xe(new il(.2,24,16),p?e.rotation:e.displacement)}});let c=[ur([0,0,0,10+1.2,0,0],e.axis),this.#t?.group,this.#e,this.#n];for(let{arrow:h,walls:u,wedge:d,dot:f}of this.#i)c.push(h.group,u?.group,d?.group,f);this.group.add(...c.filter(h=>h!=null))}take(t,e,n,s){let{shape:r}=this;r.take(e,n,s),this.#t?.take(r),t.picture.clamped==="pinned"&&(this.#e.rotation.z=r.angleAt(0));let o=this.#n;o&&(o.position.set(10,this.#l(e,n,s),0),o.rotation.z=r.angleAt(10));for(let{index:a,x:l,carrier:c,arrow:h,walls:u,wedge:d,dot:f}of this.#i){let p=r.bends||c<0?r.heightAt(l):this.#r(e,c,n,s),x=t.largest("delivered",a,null);h.take(l,p,x>0?e.at("delivered",a,n)/x:0);let m=e.at("low",a,n),g=e.at("high",a,n);u?.take(m*s*this.#s,g*s*this.#s),d?.take(l,p,s*m,s*g,s*e.at("y",a,n)),f?.position.set(l,p,0)}}get beyond(){let t=this.#i.flatMap(e=>e.walls?.limited?e.walls:[]);return t.length>0&&!t.some(({seen:e})=>e)}haunt(t,e,n,s){if(this.#o&&this.#o.run!==t&&(this.group.remove(this.#o.outline.line),this.#o.outline.dispose(),this.#o=null),!!t){if(!this.#o){let r=new Tl(t,this.#s);if(!r.bends)return;this.#o={run:t,shape:r,outline:new $u(r,this.#a)},this.group.add(this.#o.outline.line)}this.#o.outline.line.visible=e!==null,e&&(this.#o.shape.take(e,n,s),this.#o.outline.take(this.#o.shape))}}dispose(){this.group.traverse(t=>{(t instanceof Xe||t instanceof Cs)&&t.geometry.dispose()})}#r(t,e,n,s){return t.at("y",e,n)*s*this.#s}#l(t,e,n){if(this.shape.bends)return this.shape.heightAt(10);let s=this.#i.find(({port:r,x:o})=>r.motion_unit==="m"&&o>.99*10);return s?this.#r(t,s.index,e,n):0}};function $p(i,t){return i.bounded("low",t)||i.bounded("high",t)}var ju=class{body=new Wo({polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});block=new Wo({polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});edge=new Si;faint=new Si({transparent:!0,opacity:.5});axis=new Si;section=new Si({transparent:!0,opacity:.8});centre=new Rs;limit=new Si;wall=new Rs({transparent:!0,opacity:.22,depthWrite:!1});ghost=new Si({depthTest:!1,transparent:!0});displacement=new Rs;rotation=new Rs;needle=new Si;take(t,e){let n=r=>new he(t.colour(r)),s=r=>n("paper").lerp(n("ink"),r);this.body.color.copy(s(t.dark?.3:.13)),this.block.color.copy(s(t.dark?.2:.34)),this.edge.color.copy(s(t.dark?.5:.6)),this.faint.color.copy(n("faint")),this.axis.color.copy(s(.24)),this.section.color.copy(e?n("rotation"):s(.5)),this.centre.color.copy(n("displacement")),this.limit.color.copy(n("constraint")),this.wall.color.copy(n("constraint")),this.ghost.color.copy(n("faint")),this.displacement.color.copy(n("displacement")),this.rotation.color.copy(n("rotation")),this.needle.color.copy(n("rotation"))}};var Qu=class{root=N("div",{class:"stage-tools"});#t=N("input",{type:"range",min:"0",max:"1000","aria-label":"Exaggeration of deflections"});#e=N("input",{type:"checkbox"});#n=N("span",{class:"times"});#i=1;constructor({exaggerate:t,reset:e}){this.#t.oninput=()=>t(xm(Number(this.#t.value))),this.#e.onchange=()=>t(this.#e.checked?0:this.#i);let n=N("button",{type:"button",onclick:e},"Reset view");this.root.append(this.#n,this.#t,N("label",{},this.#e," auto"),n)}show(t,e){if(this.#e.checked=e,t===this.#i&&this.#n.textContent)return;this.#i=t;let n=zu(t);le(this.#n,n),this.#t.setAttribute("aria-valuetext",n),(document.activeElement!==this.#t||e)&&(this.#t.value=String(vm(t)))}};var td=class{#t;#e=new Bu;#n;#i=N("div",{class:"stage-view"});#s=new ju;#a=new $a;#o;#r=null;#l=null;#c=null;#h="";#u=null;#d=1;#m=0;#f=0;#y=!0;#_=!0;constructor(t,e,n){if(this.#t=e,this.#n=new Qu({exaggerate:n,reset:()=>this.#x()}),t.append(this.#e.root,this.#i,this.#n.root),this.#o=WA(),this.#o){let s=this.#o.domElement;s.setAttribute("role","img"),this.#r=new ku(s,()=>this.#p());let r=new hl(16777215,1.7);r.position.set(3,8,6),this.#a.add(new al(16777215,13159634,1.9),r),this.#i.append(s),new ResizeObserver(()=>this.#g()).observe(this.#i),new IntersectionObserver(o=>{this.#y=o.at(-1)?.isIntersecting??!0,this.#y&&this.#p()}).observe(this.#i)}else this.#i.append(N("p",{class:"stage-without"},"This browser offers no WebGL, so the moving structure cannot be drawn; everything else works."))}show(t,e,n){this.#u=t,this.#_||=n,this.#m=e,this.#p()}name(t){this.#e.name(t)}repaint(){this.#s.take(this.#t,this.#l?.shape.turns??!1),this.#p()}#x(){this.#r?.reset(),this.#p()}#p(){this.#f||(this.#f=requestAnimationFrame(()=>this.#b()))}#b(){this.#f=0;let t=this.#u;if(!t||!this.#y)return;let e=t.run.trial(t.trial);e&&(this.#d=this.#m||GA(t)),this.#n.show(this.#d,this.#m===0),this.#o&&this.#r&&this.#S(t,e,this.#o,this.#r),this.#_&&(this.#_=!1,e?this.#e.show(t,this.#l?.beyond?"walls out of view":""):this.#e.show(t,`waiting for trial ${t.trial} …`))}#S(t,e,n,{camera:s}){this.#M(t),e&&this.#l?.take(t.run,e,t.time,this.#d);let r=t.pinned?.run??null;this.#l?.haunt(r,r?.trial(t.trial)??null,Math.min(t.time,r?.picture.duration??0),this.#d),n.render(this.#a,s),this.#v(t,n.domElement)}#M({run:t}){if(t===this.#c)return;this.#c=t;let e=cx(t);e!==this.#h&&(this.#h=e,this.#l&&(this.#a.remove(this.#l.group),this.#l.dispose()),this.#l=new Ku(t,this.#s),this.#s.take(this.#t,this.#l.shape.turns),this.#a.add(this.#l.group))}#g(){let{clientWidth:t,clientHeight:e}=this.#i;!this.#o||t===0||e===0||(this.#o.setPixelRatio(Math.min(devicePixelRatio,1.5)),this.#o.setSize(t,e,!1),this.#r?.fit(t/e),this.#p())}#v({run:t,trial:e},n){let s=t.picture.fields.find(({unit:a})=>a==="m"),r=s?t.largestOfField(s.name,e):0,o=s?`, which deflects by at most ${new Je(r,"m").text(r)}`:"";$i(n,`The structure in motion in trial ${e}${o}; drawn with ${zu(this.#d)}.`)}};function GA({run:i,trial:t}){let e=i.picture.fields.find(({unit:s})=>s==="m"),n=i.ports.map((s,r)=>s.motion_unit==="m"?i.largest("y",r,t):0);return _m(Math.max(e?i.largestOfField(e.name,t):0,...n),i.picture.span)}function WA(){try{let i=new Du({antialias:!0,alpha:!0,powerPreference:"low-power"});return i.setClearAlpha(0),i}catch{return null}}var ed=class{#t;#e;#n=0;constructor(t,e){this.#t=t,this.#e=e}show(t,e,n){clearTimeout(this.#n);for(let s of this.#t)s.setAttribute("aria-busy",String(t==="coming"));(n||t==="own")&&this.#i("",e),e!==""&&(t==="other"&&this.#i(`Not this scenario: last run of ${e}`,`not this scenario: last run of ${e}`),t==="coming"&&(this.#n=window.setTimeout(()=>this.#i("Being worked out …",`last run: ${e}`),200)))}#i(t,e){for(let n of this.#t)t?n.dataset.stale=t:delete n.dataset.stale;this.#e(e)}};var hx="http://www.w3.org/2000/svg",XA={play:"M5 3l9 6l-9 6z",pause:"M5 3h3v12h-3z M11 3h3v12h-3z",back:"M12 4l-6 5l6 5z M4 4h1.6v10h-1.6z",on:"M6 4l6 5l-6 5z M12.4 4h1.6v10h-1.6z",previous:"M11 4l-5 5l5 5",next:"M7 4l5 5l-5 5"},qA=new Set(["previous","next"]);function ea(i,t,e){let n=i==="play"?[Yp("play"),Yp("pause")]:[Yp(i)];return N("button",{type:"button",class:`icon ${i}`,title:t,onclick:e,"aria-label":t},...n)}function Yp(i){let t=document.createElementNS(hx,"svg"),e=document.createElementNS(hx,"path"),n={viewBox:"0 0 18 18",width:"18",height:"18","aria-hidden":"true",class:`sign-${i}${qA.has(i)?" open":""}`};for(let[s,r]of Object.entries(n))t.setAttribute(s,r);return e.setAttribute("d",XA[i]),t.append(e),t}var ux=[[1/50,"1/50"],[1/20,"1/20"],[1/10,"1/10"],[1/4,"1/4"],[1/2,"1/2"],[1,"1"],[2,"2"]],nd=class{#t;#e=N("input",{type:"range",min:"0",step:"any",class:"scrub","aria-label":"Time"});#n=N("span",{class:"time"});#i=N("select",{"aria-label":"Speed"},...ux.map(([t,e])=>N("option",{value:String(t)},`${e} × real time`)));#s=N("input",{type:"range",min:"0",step:"1","aria-label":"Trial"});#a=N("input",{type:"number",min:"0",step:"1","aria-label":"Number of the trial"});#o=N("span",{class:"faint"});#r;constructor(t,e){this.#t=ea("play","Play (space)",()=>e.play(this.#t.dataset.playing!=="true")),this.#e.oninput=()=>e.seek(Number(this.#e.value)),this.#i.onchange=()=>e.speed(Number(this.#i.value)),this.#s.oninput=()=>e.jump(Number(this.#s.value)),this.#a.onchange=()=>e.jump(Number(this.#a.value));let n=o=>()=>e.jump(Number(this.#s.value)+o),s=o=>N("input",{type:"radio",name:"span",value:o,onchange:()=>e.span(o)});this.#r={trial:s("trial"),run:s("run")};let r=N("div",{class:"transport"});t.append(r),r.append(N("div",{class:"transport-row"},ea("back","A snapshot back (,)",()=>e.step(-1)),this.#t,ea("on","A snapshot on (.)",()=>e.step(1)),this.#e,this.#n,N("label",{class:"speed"},N("span",{class:"word"},"Speed "),this.#i)),N("div",{class:"transport-row"},N("div",{class:"trials"},N("span",{class:"word"},"Trial"),ea("previous","Trial before ([)",n(-1)),this.#s,ea("next","Next trial (])",n(1)),this.#a,this.#o),N("fieldset",{class:"spans"},N("legend",{class:"unseen"},"What the plots show"),N("label",{},this.#r.trial,N("span",{},"this trial")),N("label",{},this.#r.run,N("span",{},"whole run")))))}show(t,e,n){let{run:s,trial:r,span:o}=t,{trials:a,duration:l,steps:c}=s.picture,h=Math.max(1,(s.trial(r)?.stops.length??c+1)-1),u=Ar({...t,pinned:null});dr(this.#e,"max",String(u)),dr(this.#e,"step",String(l/h)),dr(this.#e,"value",String($s(t))),dr(this.#s,"max",String(a-1)),dr(this.#s,"value",String(r)),dr(this.#a,"max",String(a-1)),document.activeElement!==this.#a&&dr(this.#a,"value",String(r)),le(this.#o,`of ${a}, from 0`);let d=`${$s(t).toFixed(l<.1?5:3)} s`;le(this.#n,`${d} of ${Number(u.toFixed(6))} s`),this.#e.setAttribute("aria-valuetext",`${d}, trial ${r}`),this.#s.setAttribute("aria-valuetext",`trial ${r} of ${a}`),this.#r[o].checked=!0;let f=ux.reduce((p,x)=>Math.abs(x[0]-n)<Math.abs(p[0]-n)?x:p);dr(this.#i,"value",String(f[0])),this.#t.dataset.playing!==String(e)&&(this.#t.dataset.playing=String(e),this.#t.setAttribute("aria-label",e?"Pause (space)":"Play (space)"),this.#t.title=e?"Pause (space)":"Play (space)")}};function dr(i,t,e){(t==="value"?i.value!==e:i.getAttribute(t)!==e)&&(t==="value"?i.value=e:i.setAttribute(t,e))}var dx={FAIL:0,PASS:1,note:2,"n/a":3},id=class{#t=N("div",{class:"verdicts"});constructor(t){t.append(this.#t)}show(t){if(this.#t.setAttribute("aria-busy",String(t===null)),t===null){this.#t.firstChild?this.#t.dataset.stale="Of the run before":this.#t.append(N("p",{class:"faint"},"The run is being reviewed …"));return}delete this.#t.dataset.stale;let e=new Set([...this.#t.querySelectorAll("details[data-section]")].filter(n=>n.open).map(n=>n.dataset.section));this.#t.replaceChildren(N("h2",{},"Verdict"),N("p",{class:"verdict"},t.verdict),...t.claims.length>0?[$A(t.claims)]:[],...t.findings.length>0?[N("h3",{},"Audit"),...t.audit?[N("p",{class:"card-caption"},t.audit)]:[]]:[],...YA(t.findings).map(([n,s])=>ZA(n,s,e.has(n))))}};function $A(i){let t=["Claim","Statement","Measured","Verdict"].map(e=>N("th",{scope:"col"},e));return N("table",{class:"claims"},N("caption",{class:"unseen"},"Claims of the scenario"),N("thead",{},N("tr",{},...t)),N("tbody",{},...i.map(e=>N("tr",{},N("th",{scope:"row"},e.id),N("td",{},e.statement,...fx(e)),N("td",{class:"measured"},e.measured),N("td",{},px(e.verdict))))))}function YA(i){let t=new Map;for(let e of i)t.set(e.section,[...t.get(e.section)??[],e]);return[...t]}function ZA(i,t,e){let n=t.filter(({verdict:l})=>l==="PASS"||l==="FAIL"),s=n.filter(({verdict:l})=>l==="PASS").length,r=s<n.length,o=n.length===0?"nothing to be judged":`${s} of ${n.length} hold`,a=[...t].sort((l,c)=>dx[l.verdict]-dx[c.verdict]);return N("details",{class:"findings",open:e||r,"data-section":i},N("summary",{},N("span",{},i),N("span",{class:r?"count bad":"count"},o)),N("ul",{},...a.map(JA)))}function JA(i){return N("li",{class:i.verdict==="note"||i.verdict==="n/a"?"subdued":""},px(i.verdict),N("div",{},N("span",{class:"finding-statement"},i.statement)," ",N("span",{class:"measured"},i.measured),...fx(i)))}function fx({criterion:i}){return i?[N("div",{class:"criterion"},i)]:[]}function px(i){let t={PASS:"✓ PASS",FAIL:"✗ FAIL",note:"note","n/a":"n/a"};return N("span",{class:`badge ${i==="n/a"?"na":i.toLowerCase()}`},t[i])}var KA=60,jA=1e-6,QA=.1,tR=3,sd=class{#t;#e=new ic;#n;#i;#s;#a;#o;#r=_d();#l=new WeakSet;#c=null;#h="";#u=!1;#d=0;#m=null;#f=0;#y=0;#_=-1/0;constructor(t,e){this.#t=e;let n=a=>this.#b(a),s=a=>this.#S(a),r=a=>this.#M(a),o=a=>this.#g({playing:a});this.#n=new td(t.stage,this.#e,a=>this.#g({exaggeration:a})),this.#i=new nd(t.transport,{play:o,step:r,seek:n,jump:s,speed:a=>this.#g({speed:a}),span:a=>this.#g({span:a})}),this.#s=new Pc(t.panels,{look:this.#e,seek:n,jump:s}),this.#a=new id(t.verdicts),this.#o=new ed([t.stage,t.panels,t.verdicts],a=>this.#n.name(a)),q0({" ":()=>o(!this.#r.playing),",":()=>r(-1),".":()=>r(1),"[":()=>s(this.#r.trial-1),"]":()=>s(this.#r.trial+1)})}get state(){return{...this.#r}}set state(t){this.#v(t)}stand(t){this.#x(t,!1)}async show(t,e,n){this.#c=t,this.#h=e,this.#x(n,!0),this.#v({},!0),document.hidden||await new Promise(s=>requestAnimationFrame(s))}more(t){let e=this.#p();!e||t!==this.#c&&t!==this.#m?.run||t.has(e.trial)&&!this.#l.has(t)&&this.#w(e)}pin(t,e){this.#m=t&&{run:t,label:e};let n=this.#p();n&&this.#w(n)}review(t){this.#a.show(t)}colours(t){this.#e.read(t),this.#n.repaint(),this.#s.repaint()}#x(t,e){let n=t==="coming";this.#u=n,this.#o.show(t,this.#h,e)}#p(){let{trial:t,time:e,span:n}=this.#r;return this.#c&&{run:this.#c,pinned:this.#m,trial:t,time:e,span:n}}#b(t){if(!this.#c)return;let{trials:e,duration:n}=this.#c.picture;this.#r.span==="run"?this.#g(jm(t,e,n)):this.#g({time:Math.min(Math.max(t,0),n)})}#S(t){!this.#c||!Number.isFinite(t)||this.#g({trial:Math.min(Math.max(Math.round(t),0),this.#c.picture.trials-1)})}#M(t){let e=this.#c?.trial(this.#r.trial)?.stops;if(!this.#c||!e)return;let{trials:n,duration:s}=this.#c.picture,r=jA*s,o=t>0?oo(e,this.#r.time+r)+1:oo(e,this.#r.time-r),a=e[o];a!==void 0?this.#g({playing:!1,time:a}):this.#g({playing:!1,...Cd({trial:this.#r.trial,time:t>0?s:0},t>0?0:n*s-1e-9,n,s)})}#g(t){this.#v(t),this.#t.state()}#v(t,e=!1){let n={...this.#r};Object.assign(this.#r,t);let s=this.#c;if(!s)return;this.#r.trial=Math.min(this.#r.trial,Math.max(s.picture.trials-1,0)),this.#r.time=Math.min(this.#r.time,s.picture.duration),s.looked=this.#r.trial;let r=n.trial!==this.#r.trial,o=this.#p();(e||r||n.playing!==this.#r.playing)&&(this.#_=-1/0),e||r||n.span!==this.#r.span?this.#w(o):this.#E(o),(r||e&&!s.has(this.#r.trial))&&this.#t.trial(this.#r.trial),this.#A()}#w(t){for(let e of[t.run,t.pinned?.run])e?.has(t.trial)?this.#l.add(e):e&&this.#l.delete(e);this.#s.draw(t),this.#E(t)}#E(t){let e=performance.now(),n=!this.#r.playing||e-this.#_>KA;n&&(this.#_=e),this.#n.show(t,this.#r.exaggeration,n),n&&this.#i.show(t,this.#r.playing,this.#r.speed),this.#s.cursor(t)}#A(){this.#r.playing&&!this.#f&&(this.#y=performance.now(),this.#f=requestAnimationFrame(t=>this.#T(t)))}#T(t){this.#f=0;let e=this.#c;if(!e||!this.#r.playing)return;if(this.#u&&++this.#d<tR){this.#f=requestAnimationFrame(o=>this.#T(o));return}this.#d=0;let n=Math.min(Math.max(t-this.#y,0)/1e3,QA)*this.#r.speed;this.#y=t;let{trials:s,duration:r}=e.picture;e.has(this.#r.trial)&&s>0&&this.#v(Cd(this.#r,n,s,r)),this.#f||=requestAnimationFrame(o=>this.#T(o))}};var eR={toml:"Writing the scenario.",netcdf:"Writing the result.",figures:"Drawing the figures; this takes a few seconds.",report:"Making the report; this takes a few seconds."},rd=class{constructor(t,e,n){this.schema=t;this.start=e;this.scenario=new Yl(e,()=>this.changed());let s={stage:In("stage"),transport:In("transport"),panels:In("panels"),verdicts:In("verdicts")};this.view=new sd(s,{trial:r=>this.session.look(r),state:()=>this.address.renew()}),this.address=new Pl(()=>{let{preset:r,table:o}=this.scenario;return{v:1,preset:r.name,table:o,view:this.view.state}}),this.session=new ec(this.view,{drawn:r=>this.drawn(r),reviewed:r=>this.status.reviewed(r),pinned:r=>this.nowPinned(r),refused:r=>this.refused(r,"Not run"),without:()=>this.status.withoutRun(),failed:r=>this.failed(r),note:r=>this.status.say(r),line:r=>this.status.line(r)}),this.panel=new $l(In("controls"),new Il(t,this.scenario,km)),this.bar=new Jl(In("bar"),t,this.actions,n),this.refreshBar()}schema;start;status=new Kl;scenario;view;session;panel;bar;address;pinned=null;async begin(){await this.follow(t=>{let{preset:e,table:n}=t??{preset:this.start,table:this.start.table};this.scenario.begin(e,n)})}async navigate(){await this.follow(t=>t&&this.scenario.open(t.preset,t.table))}colours(t){this.view.colours(t)}undo(){this.scenario.undo()}redo(){this.scenario.redo()}async open(t){this.status.say(`Reading ${t.name}.`),await this.attempt("Not read",async()=>this.scenario.open(await Om(t)))}actions={preset:t=>{this.attempt("Not opened",async()=>this.scenario.open(await bd(t)))},undo:()=>this.undo(),redo:()=>this.redo(),pin:()=>this.session.pin(this.session.now),unpin:()=>this.session.pin(null),swap:()=>this.swap(),beside:()=>this.besideNoControl(),share:()=>{this.share()},download:t=>{this.save(t)},open:t=>{this.open(t)}};changed(){nc("dampen:changed",this.session.run(this.source())),this.status.expect(),this.panel.update(),this.refreshBar(),this.address.renew()}drawn(t){this.panel.learn(t),this.panel.show([]),this.status.picture(t),this.refreshBar()}nowPinned(t){this.pinned=t,this.status.say(t===null?"Nothing is pinned.":`Pinned: ${t}.`),this.refreshBar()}refused(t,e){this.panel.show(t),this.status.faults(t,e)}failed(t){this.status.say("Not run.",!0),this.status.tell(t)}source(){let{preset:t,table:e}=this.scenario,n=gi(e,t.table)?t.token:void 0;return{preset:t,table:e,token:n,label:Am(t.name,e,t.table)}}besideNoControl(){let{preset:t,table:e}=this.scenario;this.session.runBeside({preset:t,table:Km(e),label:"no control"})}swap(){let{now:t,pinned:e}=this.session;if(!t||!e)return;this.session.pin(t);let n={undo:()=>this.session.runBeside(e.source),redo:()=>this.session.runBeside(t.source)};this.scenario.open(e.source.preset,e.source.table,n)}async save(t){this.status.say(eR[t]),await this.attempt("Not written",async()=>{let{table:e,token:n}=this.source();await Bm(t,e,n),this.status.say("The download is ready.")})}async share(){await this.address.write();try{await navigator.clipboard.writeText(location.href),this.status.say("The link has been copied.")}catch{this.status.say("The link is in the address bar.")}}async follow(t){try{let e=await this.address.read(),n=e&&await this.presetOf(e);e&&(this.view.state=e.view),t(e&&n&&{preset:n,table:e.table})}catch{t(null),this.status.tell("This link is broken; it has not been followed.")}}async presetOf({preset:t,table:e}){return t===this.start.name?this.start:this.schema.scenarios.some(({name:s})=>s===t)?bd(t):{name:t,table:e}}async attempt(t,e){try{await e()}catch(n){n instanceof _r?this.refused(n.faults,t):this.status.say("The server does not answer.",!0)}}refreshBar(){let{preset:t,dirty:e,canUndo:n,canRedo:s}=this.scenario;document.title=`${t.name}${e?", changed":""} · dampen lab`,this.bar.update({preset:t.name,dirty:e,canUndo:n,canRedo:s,running:this.session.now!==null,pinned:this.pinned})}};var nR=["panels","controls"];function mx(){let i=nR.map(e=>({name:e,tab:In(`tab-${e}`)})),t=e=>{document.body.dataset.tab=e;for(let{name:n,tab:s}of i)s.setAttribute("aria-selected",String(n===e)),s.tabIndex=n===e?0:-1};for(let{name:e,tab:n}of i)n.addEventListener("click",()=>t(e)),n.addEventListener("keydown",s=>{if(s.key!=="ArrowLeft"&&s.key!=="ArrowRight")return;let r=i.find(o=>o.name!==e);r&&(t(r.name),r.tab.focus())});t("panels")}async function iR(){let i=null,t=new Zl(r=>i?.colours(r));mx();let[e,n]=await Promise.all([Fm(),Um()]);t.use(e.colours);let s=new rd(e,n,t);i=s,s.colours(t.dark),mm(r=>{s.open(r)}),addEventListener("hashchange",()=>{s.navigate()}),addEventListener("keydown",r=>{let o=r.target instanceof HTMLInputElement&&r.target.type==="search";!(r.ctrlKey||r.metaKey)||r.key.toLowerCase()!=="z"||o||(r.preventDefault(),r.shiftKey?s.redo():s.undo())}),await s.begin()}iR().catch(i=>{throw In("status").textContent="The page could not start.",i});
